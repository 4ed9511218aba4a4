#pragma once
#include "sdpd/threads/waiting.hpp"

namespace mesobridge::sdpd {

/// Where the threads of a team meet between two phases.
class Barrier {
 public:
  explicit Barrier(int threads) : threads_(threads) {}

  void wait() {
    auto const phase = phase_.load(std::memory_order_relaxed);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 < threads_)
      return wait_while(phase_, phase);
    arrived_.store(0, std::memory_order_relaxed);
    change(phase_);
  }

 private:
  int threads_;
  alignas(64) std::atomic<int> arrived_ = 0;
  alignas(64) Signal phase_ = 0;
};

} // namespace mesobridge::sdpd
