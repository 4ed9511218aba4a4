#pragma once
#include "md/error.hpp"
#include <cstdint>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

namespace mesobridge::sdpd {

/// Collects what went wrong inside a parallel loop, where exceptions cannot leave. Of several failures the
/// one of the particle with the smallest id is kept, so that the message does not depend on the threads.
class Failure {
 public:
  void report(std::uint32_t id, std::string message) {
    std::lock_guard const lock(mutex_);
    if (id < id_) {
      id_ = id;
      message_ = std::move(message);
    }
  }
  bool any() const { return id_ != none; }
  std::uint32_t id() const { return static_cast<std::uint32_t>(id_); }
  std::string const& message() const { return message_; }

 private:
  static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
  std::mutex mutex_;
  std::uint64_t id_ = none;
  std::string message_;
};

} // namespace mesobridge::sdpd
