#pragma once
#include "sdpd/simulation.hpp"
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

/// What is true of every fluid, whatever its particles are.
namespace mesobridge::sdpd {

template <class T>
bool same_bits(std::vector<T> const& a, std::vector<T> const& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
inline bool same_bits(Snapshot const& a, Snapshot const& b) {
  return same_bits(a.q, b.q) && same_bits(a.p, b.p) && same_bits(a.eps, b.eps) && same_bits(a.rho, b.rho) &&
         same_bits(a.T, b.T) && same_bits(a.P, b.P);
}

/// In so many steps, in which the lists of neighbours are renewed.
inline void expect_same_bits_for_any_number_of_threads(SimulationSettings settings, std::uint64_t steps) {
  std::vector<Snapshot> results;
  for (int const threads : {1, 2, 4}) {
    settings.threads = threads;
    Simulation simulation(settings);
    simulation.advance(steps);
    EXPECT_GT(simulation.list_renewals(), 1u);
    results.push_back(simulation.snapshot());
  }
  EXPECT_TRUE(same_bits(results[0], results[1]));
  EXPECT_TRUE(same_bits(results[0], results[2]));
  settings.seed += 1;
  Simulation other(settings);
  other.advance(steps);
  EXPECT_FALSE(same_bits(results[0], other.snapshot()));
}

/// From a checkpoint after so many steps.
inline void expect_to_go_on_bit_for_bit(SimulationSettings const& settings, std::uint64_t steps) {
  Simulation unbroken(settings);
  unbroken.advance(steps);
  auto const checkpoint = unbroken.checkpoint();
  unbroken.advance(30);
  Simulation resumed(settings);
  resumed.restore(checkpoint);
  resumed.advance(30);
  EXPECT_TRUE(same_bits(unbroken.snapshot(), resumed.snapshot()));
  EXPECT_EQ(unbroken.observe().energy(), resumed.observe().energy());
  EXPECT_EQ(unbroken.observe().P, resumed.observe().P);
  EXPECT_EQ(resumed.observe().step, steps + 30);
}

/// To round-off, in so many steps.
inline void expect_conserved_momentum(SimulationSettings const& settings, std::uint64_t steps) {
  Simulation simulation(settings);
  simulation.advance(steps);
  auto const now = simulation.observe();
  double const scale = std::sqrt(2 * now.kinetic * static_cast<double>(simulation.size()));
  EXPECT_LT(norm(now.momentum) / scale, 1e-14);
}

} // namespace mesobridge::sdpd
