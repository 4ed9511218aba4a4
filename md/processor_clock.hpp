#pragma once
#include <ctime>

namespace mesobridge::md {

/// Processor time of the calling thread since the clock was made: other programs on the same cores disturb it
/// far less than the time on the wall.
class ProcessorClock {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double start_ = now();
};

} // namespace mesobridge::md
