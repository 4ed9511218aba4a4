#include "md/error.hpp"
#include "same_bits.hpp"
#include "sdpd/observe/structure_factor.hpp"
#include "sdpd_fixtures.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

SimulationSettings melted(double K, double dt) {
  auto settings = argon(K, dt);
  settings.as<Sdpd>().kernel = "wendland-c4";
  settings.lattice = {8, 8, 8};
  settings.melted = true;
  return settings;
}

TEST(MeltedStart, LeavesNoLattice) {
  Simulation const fresh(melted(1e4, 1e-3));
  auto on_lattice = melted(1e4, 1e-3);
  on_lattice.melted = false, on_lattice.disorder = 0.15;
  Simulation const lattice(on_lattice);
  auto const peak = [](Simulation const& of) { return structure_peak(of.snapshot().q, of.box()); };
  EXPECT_GT(peak(lattice).largest, 100); // 512 exp(-(2 pi 0.15)^2) = 211
  EXPECT_LT(peak(fresh).largest, 30);    // about ln 1670 times the peak's mean of 2 ... 3
  EXPECT_LT(fresh.crystal_fraction(), 0.05);
  EXPECT_LT(fresh.pairing_fraction(), 0.01);
}

// The energy of a disordered start is hundreds of k_B T a particle of 10^6 molecules; here it is gone.
TEST(MeltedStart, SetsNoHeatFree) {
  int ran = 0;
  for (double const K : {1e5, 1e6}) {
    SCOPED_TRACE(K);
    auto settings = melted(K, 0.3 / std::sqrt(K));
    Simulation simulation(settings);
    double hottest = 0;
    for (int k = 0; k < 40; ++k) {
      simulation.advance(5);
      hottest = std::max(hottest, simulation.observe().T_kin);
    }
    EXPECT_LT(hottest, 1.15); // it begins at 1, and half goes into the springs
    ++ran;
  }
  EXPECT_EQ(ran, 2);
}

TEST(MeltedStart, HasTheSameBitsOnAnyNumberOfThreads) {
  auto settings = melted(1e5, 1e-3);
  settings.lattice = {6, 7, 8};
  expect_same_bits(settings, 3, 2,
                   [](Simulation const& at) { return flat(at.snapshot().q, at.snapshot().eps); });
}

TEST(MeltedStart, IsForSdpdWithoutRegions) {
  auto dpd = SimulationSettings{
      .method = Dpd{{.mass = 1, .potential = SoftPotential(1, 1), .friction = PowerFriction(1, 0, 1, 2)}},
      .rho = 3,
      .T = 1,
      .melted = true,
      .dt = 0.01};
  EXPECT_THROW(Simulation{dpd}, InputError);
}

} // namespace
} // namespace mesobridge::sdpd
