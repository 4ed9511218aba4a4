#include "sdpd/team.hpp"
#include "md/error.hpp"
#include "sdpd/waiting.hpp"
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace mesobridge::sdpd {
namespace {

/// The door between a worker and the task: the team's thread opens it and closes it again, and waits only
/// when it finds the worker inside.
enum Door : std::uint32_t { closed, open, inside };

/// One thread, in cache lines of its own.
struct alignas(64) Worker {
  Signal door = closed;
  std::thread thread;
};

} // namespace

struct Team::State {
  std::vector<std::unique_ptr<Worker>> workers;
  void (*task)(void const*, int) = nullptr; ///< none: the team ends
  void const* data = nullptr;
  pid_t process = getpid();

  void live(Worker& self, int thread) {
    for (;;) {
      wait_while(self.door, closed);
      std::uint32_t expected = open;
      if (!self.door.compare_exchange_strong(expected, inside, std::memory_order_acquire))
        continue; // it was closed again
      if (!task)
        return;
      task(data, thread);
      change_to(self.door, closed);
    }
  }

  void add_worker() {
    auto& worker = *workers.emplace_back(std::make_unique<Worker>());
    int const number = static_cast<int>(workers.size());
    try {
      worker.thread = std::thread([this, &worker, number] { live(worker, number); });
    } catch (std::system_error const& error) {
      workers.pop_back();
      throw EnvironmentError(
          fmt::format("cannot start thread {} of a run: {}; take fewer threads", number + 1, error.what()));
    }
  }
};

Team& Team::of_this_thread() {
  thread_local Team team;
  return team;
}

Team::Team() : state_(std::make_unique<State>()) {}

Team::~Team() {
  if (getpid() != state_->process) { // a fork takes one thread along: there is none to wait for
    for (auto const& worker : state_->workers)
      worker->thread.detach();
    static_cast<void>(state_.release());
    return;
  }
  state_->task = nullptr;
  for (auto const& worker : state_->workers) {
    change_to(worker->door, open);
    worker->thread.join();
  }
}

void Team::work(int threads, void (*task)(void const*, int), void const* data) {
  auto& workers = state_->workers;
  auto const others = static_cast<std::size_t>(threads - 1);
  while (workers.size() < others)
    state_->add_worker();
  state_->task = task, state_->data = data;
  for (std::size_t k = 0; k < others; ++k)
    change_to(workers[k]->door, open);
  task(data, 0);
  for (std::size_t k = 0; k < others; ++k) {
    std::uint32_t expected = open;
    if (!workers[k]->door.compare_exchange_strong(expected, closed, std::memory_order_acquire))
      wait_while(workers[k]->door, inside);
  }
}

} // namespace mesobridge::sdpd
