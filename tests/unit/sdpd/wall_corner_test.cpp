#include "moved_energy.hpp"
#include "pair_fluid_fixtures.hpp"
#include "same_bits.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/observe/list.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

/// Fluids between walls across two axes (a duct) and across all three (a closed box).
struct Case {
  std::string name;
  std::vector<int> axes;
  SimulationSettings settings;
};

Faces walls_across(std::vector<int> const& axes) {
  Faces faces{};
  for (int const axis : axes)
    faces[static_cast<std::size_t>(axis)] = walls_along(axis)[static_cast<std::size_t>(axis)];
  return faces;
}

SimulationSettings closed(SimulationSettings s, std::vector<int> const& axes) {
  s.lattice = {8, 8, 8};
  s.disorder = 0.2;
  s.faces = walls_across(axes);
  return s;
}

std::vector<Case> fluids() {
  std::vector<Case> all;
  for (auto const& [name, settings] :
       {std::pair<std::string, SimulationSettings>{"ideal_gas", ideal_gas(50, 0.02)},
        {"argon", argon(50, 0.02)},
        {"dpde", dpde_fluid(40, 0.01, 2)},
        {"dpd", dpd_fluid()}}) {
    all.push_back({name + "_in_a_duct", {1, 2}, closed(settings, {1, 2})});
    all.push_back({name + "_in_a_box", {0, 1, 2}, closed(settings, {0, 1, 2})});
  }
  return all;
}

class EveryEnclosedFluid : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Fluids, EveryEnclosedFluid, ::testing::ValuesIn(fluids()),
                         [](auto const& info) { return info.param.name; });

/// How many walls a place is nearer to than a share of the range.
int walls_near(System const& system, Vec3 const& q, double share) {
  int near = 0;
  for (auto const& wall : system.walls)
    near += wall.distance(q, 0) < share * system.neighbours.range();
  return near;
}

TEST_P(EveryEnclosedFluid, HasForcesInItsCornersThatAreTheSlopeOfItsEnergy) {
  auto const system = make_system(GetParam().settings);
  auto const f = system->particles.f;
  auto const walls = static_cast<int>(GetParam().axes.size());
  int corners = 0;
  double const step = 1e-5;
  for (std::size_t i = 0; i < system->size() && corners < 6; ++i) {
    if (walls_near(*system, system->particles.q[i], 0.6) < walls)
      continue;
    ++corners;
    for (int const axis : {0, 1, 2}) {
      Vec3 by;
      component(by, axis) = step;
      double const slope = (energy_with(*system, i, by) - energy_with(*system, i, -1.0 * by)) / (2 * step);
      EXPECT_NEAR(component(f[i], axis), -slope, 2e-5 * (norm(f[i]) + 1)) << i << " " << axis;
    }
  }
  EXPECT_EQ(corners, 6);
}

// Images, and images of images, are what a fluid has that is its own mirror image along each of the axes: the
// quarter or the eighth of a periodic one.
TEST_P(EveryEnclosedFluid, IsAPartOfASymmetricPeriodicOne) {
  auto const& [name, axes, settings] = GetParam();
  auto const part = make_system(settings);
  auto whole_settings = settings;
  whole_settings.faces = {};
  for (int const axis : axes)
    whole_settings.lattice[static_cast<std::size_t>(axis)] *= 2;
  auto const whole = make_system(whole_settings);
  std::size_t const copies = std::size_t{1} << axes.size();
  ASSERT_EQ(whole->size(), copies * part->size());
  std::vector<std::size_t> place(whole->size()); // of an id
  for (std::size_t k = 0; k < whole->size(); ++k)
    place[whole->particles.id[k]] = k;
  for (std::size_t i = 0; i < part->size(); ++i)
    for (std::size_t copy = 0; copy < copies; ++copy) {
      auto q = part->particles.q[i];
      for (std::size_t a = 0; a < axes.size(); ++a)
        if (copy >> a & 1)
          component(q, axes[a]) = 2 * component(part->box.edge, axes[a]) - component(q, axes[a]);
      auto const k = place[copies * part->particles.id[i] + copy];
      whole->particles.q[k] = q;
      if (part->has_energies())
        whole->particles.eps[k] = part->particles.eps[i];
    }
  refresh(*whole), refresh(*part);
  for (std::size_t k = 0; k < whole->size(); ++k)
    place[whole->particles.id[k]] = k; // the lists have sorted them anew
  int in_corners = 0;
  for (std::size_t i = 0; i < part->size(); ++i) {
    auto const k = place[copies * part->particles.id[i]];
    in_corners += walls_near(*part, part->particles.q[i], 0.7) == static_cast<int>(axes.size());
    EXPECT_LT(norm(whole->particles.f[k] - part->particles.f[i]), 1e-7 * (1 + norm(part->particles.f[i])));
    if (part->has_densities()) {
      EXPECT_NEAR(whole->particles.rho[k], part->particles.rho[i], 1e-7);
      EXPECT_NEAR(whole->particles.P[k] / part->particles.P[i], 1, 1e-7);
    }
  }
  EXPECT_GT(in_corners, 6);
  double const times = static_cast<double>(copies);
  EXPECT_NEAR(whole->potential_energy, times * part->potential_energy,
              1e-9 * std::abs(whole->potential_energy));
  EXPECT_NEAR(whole->virial / (times * part->virial), 1, 1e-7);
}

// On a lattice at rest the images go on with it, into the corners.
TEST(EnclosedFluids, AtRestHaveOneDensityAndPressureUpToTheCorners) {
  for (auto settings : {ideal_gas(50, 0.02), argon(50, 0.02)}) {
    settings = closed(settings, {0, 1, 2});
    settings.disorder = 0, settings.noise = false;
    Simulation simulation(settings);
    simulation.advance(5);
    auto const now = simulation.snapshot();
    for (std::size_t i = 0; i < now.q.size(); ++i) {
      EXPECT_NEAR(now.rho[i], now.rho[0], 1e-12);
      EXPECT_NEAR(now.P[i] / now.P[0], 1, 1e-11);
    }
    EXPECT_EQ(now.q.size(), 512U);
  }
}

TEST_P(EveryEnclosedFluid, BalancesMomentumToRoundOffAndEnergyByTheWorkOfAPiston) {
  auto settings = GetParam().settings;
  auto const& units = settings.units();
  settings.faces[2][0].motion = {0.3 * units.velocity(), 2 * units.time(), {}};
  Simulation simulation(settings);
  auto const before = simulation.observe();
  double const scale = std::sqrt(2 * before.kinetic * static_cast<double>(simulation.size()));
  simulation.advance(200);
  auto const after = simulation.observe();
  Vec3 impulse;
  double work = 0;
  for (auto const& wall : simulation.walls())
    component(impulse, wall.axis) += wall.impulse, work += wall.work;
  EXPECT_GT(norm(impulse) / scale, 1e-2);
  EXPECT_LT(norm(after.momentum - before.momentum - impulse) / scale, 1e-12);
  if (!settings.features().energies)
    return;
  EXPECT_GT(work / before.kinetic, 0.05);
  EXPECT_LT(std::abs(after.energy() - before.energy()), 6e-3 * work); // Verlet's error
}

TEST_P(EveryEnclosedFluid, HasTheSameBitsOnAnyNumberOfThreadsAndAfterARestart) {
  auto settings = GetParam().settings;
  for (auto& pair : settings.faces)
    for (auto& face : pair)
      if (face.kind == FaceKind::wall)
        face.friction = {.acts = true, .temperature = settings.T};
  settings.faces[2][0].motion.velocity = 0.3 * settings.units().velocity();
  expect_same_bits(settings, 30, 20, [](Simulation const& at) {
    auto values = flat(at.snapshot().q, at.snapshot().eps);
    for (auto const& wall : at.walls())
      values.insert(values.end(), {wall.impulse, wall.work, wall.heat, wall.drag.x});
    return values;
  });
}

// A piston that has come half the box's way leaves the walls beside it half their area.
TEST(EnclosedFluids, FeelTheirPressureOnTheAreaThatThePistonLeaves) {
  auto settings = closed(ideal_gas(50, 0.02), {0, 2});
  settings.faces[2][0].motion.velocity = settings.units().velocity();
  auto const system = make_system(settings);
  auto const all = measurements();
  auto const pressure = std::ranges::find(all, "wall_pressure", &Measurement::name);
  ASSERT_NE(pressure, all.end());
  auto const pressures = std::get<Measurement::FromSystem>(pressure->values);
  auto const edge = system->box.edge;
  for (double const way : {0.0, 0.5 * edge.z}) {
    system->wall_time = way;
    double const of_both = edge.y * (edge.z - way) + edge.x * edge.y;
    auto const& walls = system->walls; // lower and upper across x, then z
    EXPECT_NEAR(pressures(*system)[0] * of_both / (walls[0].force + walls[2].force), 1, 1e-12);
    EXPECT_NEAR(pressures(*system)[1] * of_both / (walls[1].force + walls[3].force), -1, 1e-12);
  }
}

// Two walls that meet must not give one particle the same kicks.
TEST(Corners, HaveWallsWithNumbersOfTheirOwn) {
  auto const system = make_system(closed(dpd_fluid(), {0, 1, 2}));
  ASSERT_EQ(system->walls.size(), 6U);
  for (std::uint32_t k = 0; k < 6; ++k)
    EXPECT_EQ(system->walls[k].number, k);
  EXPECT_EQ(system->corners.size(), 12U + 8U);
  EXPECT_EQ(make_system(closed(dpd_fluid(), {1, 2}))->corners.size(), 4U);
  EXPECT_EQ(make_system(closed(dpd_fluid(), {1}))->walls[1].number, 1U);
}

} // namespace
} // namespace mesobridge::sdpd
