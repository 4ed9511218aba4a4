#include "fitting/shock_relations.hpp"
#include "sdpd/observe/profile.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

/// Argon at 1150 kg/m^3 and 500 K without noise, K = 100, before a piston at 500 m/s that is ramped over 8
/// l/v_S, so that the fluid at the piston is neither overheated nor compressed without a shock. The viscosity
/// is such that the front is smooth: rho_0 v_S l/(4 eta/3) = 1.5. Many neighbours, so that their sum is right
/// before the shock and behind it.
SimulationSettings argon_before_a_piston() {
  auto settings = argon(100, 0.02);
  settings.T = 500;
  settings.lattice = {8, 8, 90};
  settings.noise = false;
  settings.as<Sdpd>().kernel = "wendland-c4";
  settings.as<Sdpd>().h_factor = 3.3;
  double const as_it_is = Simulation(settings).observe().rho;
  settings.as<Sdpd>().density_correction.scale = 1 / as_it_is;
  settings.faces = walls_along(2, {.velocity = 500, .ramp = 1.3 * settings.units().time()});
  return settings;
}

/// Means over what lies between two places along z, in the units of the settings.
struct Plateau {
  double rho = 0, mass_per_volume = 0, P = 0, T = 0, v = 0, count = 0;
};

Plateau plateau(Simulation const& simulation, double from, double to) {
  auto const now = simulation.snapshot();
  auto const& units = simulation.units();
  Plateau mean;
  for (std::size_t i = 0; i < now.q.size(); ++i)
    if (now.q[i].z > from && now.q[i].z < to)
      mean.rho += now.rho[i], mean.P += now.P[i], mean.T += now.T[i], mean.v += now.p[i].z, ++mean.count;
  auto const edge = simulation.box().edge;
  mean.mass_per_volume = mean.count / (edge.x * edge.y * (to - from)) * units.density;
  mean.rho *= units.density / mean.count;
  mean.P *= units.pressure() / mean.count, mean.T *= units.temperature / mean.count;
  mean.v *= units.velocity() / mean.count;
  return mean;
}

/// Where the mean velocity falls through half of `v`, coming from the fluid at rest; reduced.
double front(Simulation const& simulation, double v) {
  std::size_t const slices = 90;
  auto const mean = profile(simulation.snapshot(), simulation.box(), {2, slices}, 1).velocity;
  double const width = simulation.box().edge.z / slices;
  for (std::size_t s = slices - 1; s > 0; --s)
    if (mean[s - 1].z > v / 2)
      return width * (static_cast<double>(s) + 0.5 - (v / 2 - mean[s].z) / (mean[s - 1].z - mean[s].z));
  return 0;
}

TEST(Piston, DrivesTheShockOfRankineAndHugoniot) {
  auto const settings = argon_before_a_piston();
  auto const ahead = std::visit(
      [&](auto const& eos) { return fitting::state_from_temperature(eos, settings.rho, settings.T); },
      settings.as<Sdpd>().eos);
  auto const exact = fitting::Hugoniot(fitting::Fluid(settings.as<Sdpd>().eos), ahead).from_piston(500);
  Simulation simulation(settings);
  auto const units = simulation.units();
  double const v = 500 / units.velocity(), energy = simulation.observe().energy();
  simulation.advance(350);
  double const first = front(simulation, v), impulse = simulation.walls()[0].impulse,
               began = simulation.wall_time();
  simulation.advance(250);
  double const time = simulation.wall_time() - began,
               area = simulation.box().edge.x * simulation.box().edge.y;
  double const v_S = (front(simulation, v) - first) / time * units.velocity();
  double const P_wall = (simulation.walls()[0].impulse - impulse) / (time * area) * units.pressure();
  double const piston = simulation.walls()[0].position(simulation.wall_time());
  auto const behind = plateau(simulation, piston + 15, front(simulation, v) - 12);
  ASSERT_GT(behind.count, 1000);
  EXPECT_NEAR(v_S / exact.v_S, 1, 0.003);
  EXPECT_NEAR(behind.P / exact.behind.P, 1, 0.003);
  EXPECT_NEAR(P_wall / exact.behind.P, 1, 0.003);
  EXPECT_NEAR(behind.T / exact.behind.T, 1, 0.003);
  EXPECT_NEAR(behind.v / 500, 1, 0.003);
  EXPECT_NEAR(behind.rho / exact.behind.rho, 1, 0.003);
  EXPECT_NEAR(behind.mass_per_volume / exact.behind.rho, 1, 0.01); // the sum over neighbours is 0.7 % lower
  double const work = simulation.walls()[0].work;
  auto const now = simulation.observe();
  EXPECT_LT(std::abs(now.energy() - energy), 2e-3 * work);
  EXPECT_NEAR((now.internal + now.kinetic - energy) / work, 1, 2e-3);
  EXPECT_EQ(simulation.walls()[1].work, 0);
}

} // namespace
} // namespace mesobridge::sdpd
