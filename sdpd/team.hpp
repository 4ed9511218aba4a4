#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace mesobridge::sdpd {

/// Threads that help one thread with its tasks and wait for the next in between (see wait_while). Who comes
/// too late for a task, because another process has its processor, is not waited for: tasks are made of
/// pieces, which those who are there take from each other.
class Team {
 public:
  /// That of the calling thread. It grows when needed and ends with it.
  static Team& of_this_thread();

  Team();
  ~Team();

  /// Calls task(data, 0) on the calling thread and, where they come in time, task(data, k), k = 1 ...
  /// threads-1, on others; returns when all that have begun are done. Tasks must not throw. Throws
  /// EnvironmentError when no further thread can be had.
  void work(int threads, void (*task)(void const* data, int thread), void const* data);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Calls f(thread) on this thread, as 0, and on those of its team that come in time.
template <class F>
void with_team(int threads, F const& f) {
  Team::of_this_thread().work(
      threads, [](void const* data, int thread) { (*static_cast<F const*>(data))(thread); }, &f);
}

/// Calls f(begin, end) for parts of 0 ... count-1, as many as there are threads. A thread takes the same part
/// at every call, so that what belongs to it stays in its cache, and then those that nobody has begun.
template <class F>
void for_each_part(std::size_t count, int threads, F const& f) {
  if (threads == 1)
    return f(std::size_t{0}, count);
  constexpr std::size_t most = 64; // bits of a word
  std::size_t const parts = std::min(static_cast<std::size_t>(threads), most);
  std::atomic<std::uint64_t> taken = 0;
  with_team(static_cast<int>(parts), [&](int thread) {
    for (std::size_t k = 0; k < parts; ++k) {
      std::size_t const part = (static_cast<std::size_t>(thread) + k) % parts;
      std::uint64_t const bit = std::uint64_t{1} << part;
      if (!(taken.fetch_or(bit, std::memory_order_relaxed) & bit))
        f(part * count / parts, (part + 1) * count / parts);
    }
  });
}

/// Calls f(k) for k = 0 ... count-1 on all threads.
template <class F>
void for_each_index(std::size_t count, int threads, F const& f) {
  for_each_part(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      f(k);
  });
}

} // namespace mesobridge::sdpd
