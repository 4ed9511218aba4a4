#pragma once
#include "sdpd/simulation.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {

/// Nitromethane on a regular lattice, without noise and motion: every particle is a reactor of constant
/// volume, and all are alike. With a rate that no temperature changes, K = 1 in reduced units, unless
/// `kinetics` says otherwise, and without heat.
inline SimulationSettings uniform_reactor(double dt, double progress) {
  auto settings = burning_nitromethane(100, dt, progress);
  settings.lattice = {6, 6, 6};
  settings.skin = 0.3;
  settings.noise = false;
  settings.scheme.conservative = "none";
  auto& reaction = *settings.as<Sdpd>().reaction;
  reaction.heat = 0;
  reaction.kinetics = SecondOrder{{1 / settings.units().time(), 0}, {}, NeighbourWeights::normalised};
  return settings;
}

inline SdpdReaction& reaction_of(SimulationSettings& settings) {
  return *settings.as<Sdpd>().reaction;
}

/// The progress of the particles, which must all be alike, after so many steps.
inline double progress_after(SimulationSettings const& settings, int steps) {
  Simulation simulation(settings);
  simulation.advance(static_cast<std::uint64_t>(steps));
  auto const progress = simulation.snapshot().progress;
  for (double const one : progress)
    EXPECT_NEAR(one, progress.front(), 1e-12);
  return progress.front();
}

} // namespace mesobridge::sdpd
