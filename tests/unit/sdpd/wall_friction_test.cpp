#include "cg/estimate.hpp"
#include "pair_fluid_fixtures.hpp"
#include "same_bits.hpp"
#include "sdpd/boundary/wall_friction.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/system/conservation.hpp"
#include "sdpd/system/total_energy.hpp"
#include <cstring>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

struct Case {
  std::string name;
  SimulationSettings settings;
};

/// Rough walls at the set temperature; the upper one slides, and a body force acts.
SimulationSettings driven(SimulationSettings s, int axis = 2, double slide = 0.3, double force = 0.05) {
  s.lattice = {8, 8, 8};
  s.disorder = 0.2;
  s.faces = walls_along(axis);
  auto const& units = s.units();
  auto& [lower, upper] = s.faces[static_cast<std::size_t>(axis)];
  lower.friction = {true, s.T}, upper.friction = {true, s.T};
  int const along = (axis + 1) % 3;
  component(upper.friction.slide, along) = slide * units.velocity();
  component(s.body_force.acceleration, along) = force * units.velocity() / units.time();
  return s;
}

std::vector<Case> fluids() {
  auto conducting_dpde = with_pair_conduction(dpde_fluid(40, 0.01), PowerFriction(3, 0, 1, 2));
  return {{"ideal_gas", driven(ideal_gas(50, 0.02))},
          {"argon", driven(argon(50, 0.02), 0)},
          {"conducting_argon", driven(with_conduction(argon(50, 0.02), 0.5), 0)},
          {"dpde", driven(dpde_fluid(40, 0.01, 2), 1)},
          {"conducting_dpde", driven(conducting_dpde)},
          {"dpd", driven(dpd_fluid())}};
}

class EveryRoughlyWalledFluid : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Fluids, EveryRoughlyWalledFluid, ::testing::ValuesIn(fluids()),
                         [](auto const& info) { return info.param.name; });

/// The coefficients from the positions of particles and images, anew.
WallWeights expected_weights(System const& system, Wall const& wall, Index i) {
  auto const& particles = system.particles;
  double const d_i = wall.distance(particles.q[i], 0), range = system.neighbours.range();
  WallWeights sum;
  for (Index j = 0; j < system.size(); ++j) {
    Vec3 image = particles.q[j];
    component(image, wall.axis) = 2 * wall.start - component(image, wall.axis);
    Vec3 r = particles.q[i] - image;
    for (int const axis : {(wall.axis + 1) % 3, (wall.axis + 2) % 3}) {
      double const edge = component(system.box.edge, axis);
      component(r, axis) -= edge * std::round(component(r, axis) / edge);
    }
    double const apart = norm(r), d_j = wall.distance(particles.q[j], 0);
    if (apart >= range)
      continue;
    double par = 0, perp = 0;
    if (auto const* sdpd = std::get_if<SdpdLaw>(&system.law)) {
      double const chi = std::visit([&](auto const& W) { return W.F(apart, 1 / apart); }, system.kernel) /
                         (particles.rho[i] * particles.rho[j]);
      par = sdpd->friction.par(chi), perp = sdpd->friction.perp(chi);
    } else if (apart < 1) {
      par = 4.5 * (1 - apart) * (1 - apart);
      perp = std::holds_alternative<DpdeLaw<Transverse::own>>(system.law) ? 2 * (1 - apart) * (1 - apart) : 0;
    }
    double const cosine2 = std::pow(component(r, wall.axis) / apart, 2), factor = (d_i + d_j) / d_i;
    sum.normal += factor * (par * cosine2 + perp * (1 - cosine2));
    sum.along += factor * (par * (1 - cosine2) / 2 + perp * (1 - (1 - cosine2) / 2));
  }
  return sum;
}

TEST_P(EveryRoughlyWalledFluid, HasTheFrictionOfItsPairsWithImages) {
  auto const system = make_system(GetParam().settings);
  int compared = 0;
  for (auto const& wall : system->walls)
    for (std::size_t k = 0; k < wall.layer.particles.size(); k += 7, ++compared) {
      auto const found = wall_weights(*system, wall, k),
                 expected = expected_weights(*system, wall, wall.layer.particles[k]);
      EXPECT_NEAR(found.normal, expected.normal, 1e-6 * expected.normal + 1e-12);
      EXPECT_NEAR(found.along, expected.along, 1e-6 * expected.along + 1e-12);
    }
  EXPECT_GT(compared, 20);
}

TEST_P(EveryRoughlyWalledFluid, BalancesMomentumAndEnergyToRoundOffInTheSubSteps) {
  auto const system = make_system(GetParam().settings);
  auto const list = sub_steps(GetParam().settings.scheme, *system, GetParam().settings.dt);
  int seen = 0;
  for (int k = 0; k < 20; ++k, ++system->step)
    for (auto const& part : list) {
      seen += part.name == "body force" || part.name == "friction and heat of the walls";
      ASSERT_NO_THROW(run_and_check(part, *system));
    }
  EXPECT_EQ(seen, 40);
  for (auto const& wall : system->walls)
    EXPECT_GT(std::abs(wall.heat) * norm(wall.drag), 0);
  EXPECT_NE(system->walls[1].work, 0);
  EXPECT_NE(system->body_work, 0);
}

TEST_P(EveryRoughlyWalledFluid, GainsTheWorkAndHeatOfItsWallsAndOfTheBodyForce) {
  auto settings = GetParam().settings;
  for (auto& pair : settings.faces)
    pair[1].friction.slide *= 10;
  settings.body_force.acceleration *= 10;
  Simulation simulation(settings);
  auto const before = simulation.observe();
  simulation.advance(200);
  auto const after = simulation.observe();
  if (!settings.features().energies)
    return;
  EXPECT_GT(std::abs(after.given) / before.kinetic, 0.1);
  EXPECT_LT(std::abs(after.energy() - before.energy()), 0.02 * std::abs(after.given)); // Verlet's error
}

TEST_P(EveryRoughlyWalledFluid, HasTheSameBitsOnAnyNumberOfThreadsAndAfterARestart) {
  expect_same_bits_and_gains(GetParam().settings);
}

// Particles at rest in place: the velocities of each must take Maxwell's law about the wall's, exactly, at
// any time step, and the mean heat that the bath gives be nil.
TEST(WallFriction, LeadsToMaxwellsLawAboutTheWallsVelocityAtTheWallsTemperature) {
  for (auto const& [name, settings] : one_fluid_of_each_method()) {
    constexpr double long_time = 4000;
    auto at = driven(settings, 2, 0.5, 0);
    for (auto& face : at.faces[2])
      face.friction.temperature = 1.5 * at.T;
    auto const system = make_system(at);
    auto const part = wall_friction(*system, long_time, false); // each draw is fresh
    auto const& upper = system->walls[1];
    double sum = 0, square[3] = {}, fourth = 0;
    int count = 0;
    for (; system->step < 400; ++system->step) {
      part.run(*system);
      for (std::size_t k = 0; k < upper.layer.particles.size(); ++k) {
        Index const i = upper.layer.particles[k];
        auto const weights = wall_weights(*system, upper, k);
        if (std::min(weights.along, weights.normal) * long_time < 12)
          continue; // at the edge of the range it remembers
        Vec3 const u = system->particles.p[i] - wall_velocity(*system, upper);
        sum += u.x, ++count;
        for (int axis = 0; axis < 3; ++axis)
          square[axis] += component(u, axis) * component(u, axis);
        fourth += std::pow(u.z, 4);
      }
    }
    double const n = count, T = 1.5 * system->boltzmann;
    ASSERT_GT(count, 10000) << name;
    EXPECT_LT(std::abs(sum / n), 5 * std::sqrt(T / n)) << name;
    for (double const of_axis : square)
      EXPECT_LT(std::abs(of_axis / n / T - 1), 5 * std::sqrt(2 / n)) << name;
    EXPECT_LT(std::abs(fourth / n / (3 * T * T) - 1), 5 * std::sqrt(96.0 / 9 / n)) << name;
  }
}

// Short steps keep Maxwell's law where it is, whatever the coefficients.
TEST(WallFriction, KeepsMaxwellsLawInShortStepsToo) {
  auto at = driven(dpd_fluid(), 2, 0, 0);
  auto const system = make_system(at);
  auto const part = wall_friction(*system, 0.05, false);
  std::vector<double> of_layer;
  for (; system->step < 6000; ++system->step) {
    part.run(*system);
    double sum = 0;
    for (Index const i : system->walls[0].layer.particles)
      sum += norm2(system->particles.p[i]);
    of_layer.push_back(sum / (3 * static_cast<double>(system->walls[0].layer.particles.size())));
  }
  std::span<double const> const settled(of_layer.begin() + 2000, of_layer.end());
  auto const T = cg::estimate_mean(settled);
  EXPECT_TRUE(cg::agrees(T, 1, 5)) << T.mean << " " << T.se;
  EXPECT_LT(T.se, 0.012);
}

// Conduction leads the particles in reach of a wall to its temperature: SDPD's harmonic law exp(S/k_B)/T
// makes their mean T that of the wall, DPDE's exp(S/k_B) the mean of 1/T.
TEST(WallHeat, LeadsToTheWallsTemperature) {
  for (bool const sdpd : {true, false}) {
    auto at = sdpd ? with_conduction(ideal_gas(50, 0.02), 0.5)
                   : with_pair_conduction(dpde_fluid(60), PowerFriction(20, 0, 1, 2));
    at = driven(at, 2, 0, 0);
    for (auto& face : at.faces[2])
      face.friction.temperature = 1.1 * at.T;
    auto const system = make_system(at);
    auto const part = wall_friction(*system, 0.2, false);
    auto const& wall = system->walls[0];
    std::vector<double> T;
    for (; system->step < 6000; ++system->step) {
      part.run(*system);
      thermodynamics_from_energy(*system);
      double sum = 0;
      int near = 0;
      for (Index const i : wall.layer.particles)
        if (wall.distance(system->particles.q[i], 0) < 0.5)
          sum += sdpd ? system->particles.T[i] : 1 / system->particles.T[i], ++near;
      ASSERT_GT(near, 10);
      T.push_back(sum / near);
    }
    auto const mean = cg::estimate_mean(std::span<double const>(T.begin() + 2000, T.end()));
    double const expected = sdpd ? 1.1 : 1 / 1.1;
    EXPECT_NEAR(mean.mean, expected, 5 * mean.se + 1e-3) << sdpd;
    EXPECT_LT(mean.se, 0.005) << sdpd;
  }
}

TEST(WallFriction, WaitsForTheFluidToComeToEquilibrium) {
  Simulation simulation(driven(ideal_gas(50, 0.02)));
  simulation.hold_walls(true);
  simulation.advance(10);
  EXPECT_EQ(simulation.walls()[1].work, 0);
  EXPECT_NE(simulation.walls()[1].heat, 0);
  simulation.hold_walls(false);
  simulation.advance(10);
  EXPECT_NE(simulation.walls()[1].work, 0);
}

// A wave of force in a periodic box without walls gives no momentum on the whole; the sink of a kept energy
// takes what it does.
TEST(BodyForce, GoesAsAWaveAndLeavesThroughTheSinkOfAKeptEnergy) {
  auto settings = ideal_gas(50, 0.02);
  settings.lattice = {8, 8, 8};
  settings.body_force = {.acceleration = {0.2 * settings.units().velocity() / settings.units().time(), 0, 0},
                         .across = 2,
                         .waves = 1};
  settings.scheme.keep_energy = true;
  Simulation simulation(settings);
  auto const before = simulation.observe();
  simulation.advance(100);
  auto const after = simulation.observe();
  double const edge = simulation.box().edge.z;
  double flow = 0;
  for (auto const now = simulation.snapshot(); auto const i : now.id)
    flow += 2 * now.p[i].x * std::cos(2 * M_PI * now.q[i].z / edge) / static_cast<double>(now.q.size());
  EXPECT_GT(flow, 0.1);
  double const total_before = before.kinetic + before.internal, total = after.kinetic + after.internal;
  EXPECT_NEAR(total / total_before, 1, 1e-12);
  EXPECT_NEAR(after.energy() / before.energy(), 1, 1e-12);
}

TEST(WallFriction, ThatCannotBeIsRefused) {
  auto refused = [](auto const& change) {
    auto s = driven(ideal_gas(50, 0.02));
    change(s);
    EXPECT_THROW(check(s), InputError);
  };
  EXPECT_NO_THROW(check(driven(ideal_gas(50, 0.02))));
  refused([](SimulationSettings& s) { s.faces[2][0].friction.temperature = 0; });
  refused([](SimulationSettings& s) { s.faces[2][1].friction.slide.z = 1; });
  refused([](SimulationSettings& s) { s.faces[2][1].friction.slide.x = std::nan(""); });
  refused([](SimulationSettings& s) { s.faces[0][0].friction.acts = true; });
  refused([](SimulationSettings& s) { s.faces[2][1].friction.acts = false; });
  refused([](SimulationSettings& s) { s.body_force.acceleration.x = std::nan(""); });
  refused([](SimulationSettings& s) { s.body_force.across = 3; });
  refused([](SimulationSettings& s) { s.body_force.waves = 1; });
}

} // namespace
} // namespace mesobridge::sdpd
