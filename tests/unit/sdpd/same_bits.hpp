#pragma once
#include "sdpd/simulation.hpp"
#include <cstring>
#include <functional>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {

/// The components of vectors, one after the other, behind some numbers.
inline std::vector<double> flat(std::vector<Vec3> const& vectors, std::vector<double> numbers) {
  for (auto const& v : vectors)
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
  return numbers;
}

/// Runs on 1, 2 and 4 threads, and each once more from a checkpoint after `before` of the steps: what `of`
/// says at the end must have the same bits each time.
inline void expect_same_bits(SimulationSettings settings, std::uint64_t before, std::uint64_t after,
                             std::function<std::vector<double>(Simulation const&)> const& of) {
  std::vector<double> first;
  for (int const threads : {1, 2, 4}) {
    settings.threads = threads;
    Simulation simulation(settings), resumed(settings);
    simulation.advance(before);
    resumed.restore(simulation.checkpoint());
    simulation.advance(after), resumed.advance(after);
    if (threads == 1)
      first = of(simulation);
    for (auto const* one : {&simulation, &resumed}) {
      auto const now = of(*one);
      ASSERT_EQ(now.size(), first.size());
      EXPECT_EQ(std::memcmp(now.data(), first.data(), now.size() * sizeof(double)), 0)
          << threads << (one == &resumed ? " threads, resumed" : " threads");
    }
  }
}

/// The same of momenta, internal energies and what came from outside, in 50 steps.
inline void expect_same_bits_and_gains(SimulationSettings const& settings) {
  expect_same_bits(settings, 30, 20, [](Simulation const& at) {
    auto values = flat(at.snapshot().p, at.snapshot().eps);
    values.push_back(at.observe().given);
    return values;
  });
}

} // namespace mesobridge::sdpd
