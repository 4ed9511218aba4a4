#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>

namespace mesobridge::sdpd {

/// A number that one thread changes and others wait for.
using Signal = std::atomic<std::uint32_t>;

/// Returns once the signal is no longer `old`. Phases last some 10 us, so a waiting thread spins at first:
/// waking one that sleeps takes about as long. What is not there after `patience` waits for a thread that has
/// lost its processor to another process; then it sleeps, because the other may need this very processor.
inline void wait_while(Signal const& signal, std::uint32_t old) {
  constexpr std::chrono::microseconds patience(50);
  constexpr int spins_between_looks = 64; // at the clock
  auto const changed = [&] { return signal.load(std::memory_order_acquire) != old; };
  std::chrono::steady_clock::time_point begin{};
  for (int spin = 0; !changed(); ++spin) {
    if (spin % spins_between_looks != spins_between_looks - 1)
      continue;
    auto const now = std::chrono::steady_clock::now();
    if (begin == std::chrono::steady_clock::time_point{})
      begin = now;
    else if (now - begin > patience)
      return signal.wait(old, std::memory_order_acquire);
  }
}

/// Changes the signal and wakes those who sleep. The change is a locked operation: a plain store could be
/// seen after the look whether anyone sleeps.
inline void change(Signal& signal) {
  signal.fetch_add(1, std::memory_order_seq_cst);
  signal.notify_all();
}

} // namespace mesobridge::sdpd
