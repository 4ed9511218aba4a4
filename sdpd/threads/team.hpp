#pragma once
#include <cstddef>
#include <memory>

namespace mesobridge::sdpd {

/// Threads that work for one thread, their first, and wait for its next task in between (see wait_while).
class Team {
 public:
  /// That of the calling thread. It grows when needed and ends with it.
  static Team& of_this_thread();

  Team();
  ~Team();

  /// Calls task(data, k) for k = 0 ... threads-1, k = 0 on the calling thread, and returns when all are done.
  /// Tasks must not throw. Throws EnvironmentError when no further thread can be had.
  void work(int threads, void (*task)(void const* data, int thread), void const* data);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Calls f(thread) on so many threads at once, numbered from 0, and returns when all are done.
template <class F>
void on_threads(int threads, F const& f) {
  if (threads == 1)
    f(0);
  else
    Team::of_this_thread().work(
        threads, [](void const* data, int thread) { (*static_cast<F const*>(data))(thread); }, &f);
}

/// Calls f(begin, end) once on each thread, for its part of 0 ... count-1: the same at every call, so that
/// what belongs to it stays in the thread's cache.
template <class F>
void for_each_part(std::size_t count, int threads, F const& f) {
  on_threads(threads, [&](int thread) {
    auto const t = static_cast<std::size_t>(thread), all = static_cast<std::size_t>(threads);
    f(t * count / all, (t + 1) * count / all);
  });
}

/// Calls f(k) for k = 0 ... count-1 on all threads, each with its part.
template <class F>
void for_each_index(std::size_t count, int threads, F const& f) {
  for_each_part(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      f(k);
  });
}

} // namespace mesobridge::sdpd
