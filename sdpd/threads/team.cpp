#include "sdpd/threads/team.hpp"
#include "md/error.hpp"
#include "sdpd/threads/waiting.hpp"
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace mesobridge::sdpd {
namespace {

/// One thread and the signal that it waits for; a cache line of its own.
struct alignas(64) Worker {
  Signal called = 0;
  std::thread thread;
};

} // namespace

struct Team::State {
  std::vector<std::unique_ptr<Worker>> workers;
  void (*task)(void const*, int) = nullptr; ///< none: the team ends
  void const* data = nullptr;
  alignas(64) std::atomic<int> busy = 0;
  alignas(64) Signal all_done = 0;
  pid_t process = getpid();

  void live(Worker& self, int thread) {
    for (std::uint32_t call = 0;; ++call) {
      wait_while(self.called, call);
      if (!task)
        return;
      task(data, thread);
      if (busy.fetch_sub(1, std::memory_order_acq_rel) == 1)
        change(all_done);
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
    change(worker->called);
    worker->thread.join();
  }
}

void Team::work(int threads, void (*task)(void const*, int), void const* data) {
  auto& [workers, its_task, its_data, busy, all_done, process] = *state_;
  auto const others = static_cast<std::size_t>(threads - 1);
  while (workers.size() < others)
    state_->add_worker();
  its_task = task, its_data = data;
  busy.store(threads - 1, std::memory_order_relaxed);
  auto const before = all_done.load(std::memory_order_relaxed);
  for (std::size_t k = 0; k < others; ++k)
    change(workers[k]->called);
  task(data, 0);
  if (others > 0)
    wait_while(all_done, before);
}

} // namespace mesobridge::sdpd
