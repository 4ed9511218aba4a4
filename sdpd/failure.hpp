#pragma once
#include "md/error.hpp"
#include <cstdint>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

namespace mesobridge::sdpd {

/// Collects what went wrong inside a parallel loop, where exceptions cannot leave. Of several failures the
/// one with the smallest rank is kept, so that the message does not depend on the threads.
class Failure {
 public:
  void report(std::uint64_t rank, std::string message) {
    std::lock_guard const lock(mutex_);
    if (rank < rank_) {
      rank_ = rank;
      message_ = std::move(message);
    }
  }
  void throw_if_any() const {
    if (rank_ != std::numeric_limits<std::uint64_t>::max())
      throw PhysicsError(message_);
  }

 private:
  std::mutex mutex_;
  std::uint64_t rank_ = std::numeric_limits<std::uint64_t>::max();
  std::string message_;
};

} // namespace mesobridge::sdpd
