#include "pair_fluid_fixtures.hpp"
#include "same_bits.hpp"
#include "sdpd/observe/list.hpp"
#include "sdpd_fixtures.hpp"
#include "walled.hpp"
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
  for (std::size_t i = 0; i < system->size() && corners < 6; ++i) {
    if (walls_near(*system, system->particles.q[i], 0.6) < walls)
      continue;
    ++corners;
    expect_slope_of_energy(*system, i, f[i]);
  }
  EXPECT_EQ(corners, 6);
}

// Images, and images of images, are what a fluid has that is its own mirror image along each of the axes: the
// quarter or the eighth of a periodic one.
TEST_P(EveryEnclosedFluid, IsAPartOfASymmetricPeriodicOne) {
  auto const& [name, axes, settings] = GetParam();
  MirroredFluid const fluid(settings, axes);
  fluid.expect_same(1e-7);
  auto const& part = *fluid.part;
  int in_corners = 0;
  for (auto const& q : part.particles.q)
    in_corners += walls_near(part, q, 0.7) == static_cast<int>(axes.size());
  EXPECT_GT(in_corners, 6);
  EXPECT_NEAR(fluid.whole->virial / (static_cast<double>(fluid.copies) * part.virial), 1, 1e-7);
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
  expect_balance_with_walls(settings, 6e-3); // Verlet's error
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
