#pragma once
#include <algorithm>
#include <chrono>
#include <optional>

namespace mesobridge::workflows {

/// The time that a program may take, from now on; it is over a little earlier, so that what was done can be
/// stored: by a twentieth of it, at most a minute.
class TimeLimit {
 public:
  explicit TimeLimit(std::optional<double> hours) {
    if (!hours)
      return;
    std::chrono::duration<double> const all(3600 * *hours), spared(std::min(60.0, 180 * *hours));
    end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(all - spared);
  }
  bool is_over() const { return end_ && Clock::now() >= *end_; }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> end_;
};

} // namespace mesobridge::workflows
