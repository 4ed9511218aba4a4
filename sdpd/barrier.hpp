#pragma once
#include <atomic>
#include <thread>

namespace mesobridge::sdpd {

/// Where the threads of a team meet between two phases. Phases last some 10 us, so waiting threads spin;
/// after a while they give their processor away, because on a busy machine the thread that they wait for may
/// need it.
class Barrier {
 public:
  explicit Barrier(int threads) : threads_(threads) {}

  void wait() {
    unsigned const phase = phase_.load(std::memory_order_relaxed);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_) {
      arrived_.store(0, std::memory_order_relaxed);
      phase_.store(phase + 1, std::memory_order_release);
      return;
    }
    for (int spins = 0; phase_.load(std::memory_order_acquire) == phase; ++spins)
      if (spins > patience)
        std::this_thread::yield();
  }

 private:
  static constexpr int patience = 20000;
  int threads_;
  alignas(64) std::atomic<int> arrived_ = 0;
  alignas(64) std::atomic<unsigned> phase_ = 0;
};

} // namespace mesobridge::sdpd
