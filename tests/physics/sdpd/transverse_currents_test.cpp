#include "cg/viscosity.hpp"
#include "pair_fluid_fixtures.hpp"
#include "physics/sdpd/motion_series.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

/// The motion of a fluid at rest, in reduced units.
cg::BlobSeries motion_of(SimulationSettings const& settings, int frames, std::uint64_t between) {
  Simulation simulation(settings);
  simulation.advance(600);
  return motion_from_here(simulation, frames, between, settings.dt);
}

// The DPD fluid of Groot and Warren at steps of 0.02: 0.810(6) by waves of force, sdpd/README.md, Eq. (S54),
// where the friction of pairs alone makes 0.162 and with the motion of the particles 0.957, Eq. (S55).
TEST(TransverseCurrents, OfDpdHaveTheViscosityThatWavesOfForceFind) {
  auto settings = dpd_fluid();
  settings.dt = 0.02 / settings.units().time();
  auto const found = cg::viscosity(motion_of(settings, 2400, 5));
  double const unit = settings.units().viscosity();
  auto const eta = cg::scaled(found.eta, unit);
  RecordProperty("eta", std::to_string(eta.mean) + " +- " + std::to_string(eta.se));
  EXPECT_LT(std::abs(cg::deviation(eta, 0.810)), 4) << eta.mean << " " << eta.se;
  EXPECT_LT(eta.se, 0.05);
  EXPECT_GT(std::abs(cg::deviation(eta, 0.55)), 4); // a wrong answer is seen
  EXPECT_LT(found.chi2, 14);
  for (auto const& wave : found.waves)
    EXPECT_LT(std::abs(cg::deviation(wave.temperature, 1)), 5) << wave.k; // equipartition, wave by wave
  EXPECT_EQ(found.waves.size(), 4u);
}

} // namespace
} // namespace mesobridge::sdpd
