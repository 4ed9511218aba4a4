#include "cg/estimate.hpp"
#include "pair_fluid_fixtures.hpp"
#include "same_bits.hpp"
#include "sdpd/observe/virials.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd_fixtures.hpp"
#include "walled.hpp"
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

/// Fluids of every method between walls across z, the lower one a piston.
struct Case {
  std::string name;
  SimulationSettings settings;
};

SimulationSettings between_walls(SimulationSettings s, double piston, int axis = 2) {
  s.lattice = {8, 8, 8};
  s.disorder = 0.2;
  s.faces = walls_along(axis, {piston * s.units().velocity(), 2 * s.units().time()});
  return s;
}

std::vector<Case> fluids() {
  return {{"ideal_gas", between_walls(ideal_gas(50, 0.02), 0.3)},
          {"argon", between_walls(argon(50, 0.02), 0.3, 0)},
          {"dpde", between_walls(dpde_fluid(40, 0.01, 2), 0.3, 1)},
          {"dpd", between_walls(dpd_fluid(), 0.3)}};
}

class EveryWalledFluid : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Fluids, EveryWalledFluid, ::testing::ValuesIn(fluids()),
                         [](auto const& info) { return info.param.name; });

// The forces of the images, too, are those of an energy.
TEST_P(EveryWalledFluid, HasForcesThatAreTheSlopeOfItsEnergy) {
  auto settings = GetParam().settings;
  settings.faces = walls_along(settings.faces[0][0].kind == FaceKind::wall   ? 0
                               : settings.faces[1][0].kind == FaceKind::wall ? 1
                                                                             : 2);
  auto const system = make_system(settings);
  auto const f = system->particles.f;
  int near = 0;
  for (std::size_t i = 0; i < system->size() && near < 12; ++i) {
    auto const& wall = system->walls[i % 2];
    if (wall.distance(system->particles.q[i], 0) > 0.5 * system->neighbours.range())
      continue;
    ++near;
    expect_slope_of_energy(*system, i, f[i]);
  }
  EXPECT_EQ(near, 12);
}

TEST_P(EveryWalledFluid, BalancesMomentumToRoundOffAndEnergyByTheWork) {
  expect_balance_with_walls(GetParam().settings, 4e-3); // Verlet's error
}

TEST_P(EveryWalledFluid, HasTheSameBitsOnAnyNumberOfThreadsAndAfterARestart) {
  expect_same_bits(GetParam().settings, 40, 20, [](Simulation const& at) {
    auto values = flat(at.snapshot().q, at.snapshot().eps);
    values.insert(values.end(), {at.wall_time(), at.walls()[0].work});
    return values;
  });
}

// The pressure, too, is that of the fluid and its images, and the walls feel it.
TEST_P(EveryWalledFluid, HasThePressureThatItsWallsFeel) {
  auto settings = GetParam().settings;
  for (auto& pair : settings.faces)
    for (auto& face : pair)
      face.motion = {};
  Simulation simulation(settings);
  simulation.advance(300);
  auto const& walls = simulation.walls();
  double const began = walls[0].impulse - walls[1].impulse;
  std::vector<double> P;
  int const samples = 400;
  for (int k = 0; k < samples; ++k) {
    simulation.advance(5);
    P.push_back(simulation.observe().P);
  }
  auto const mean = cg::estimate_mean(P);
  double const area = simulation.box().volume() / component(simulation.box().edge, walls[0].axis);
  double const felt = (walls[0].impulse - walls[1].impulse - began) / (2 * area * 5 * samples * settings.dt);
  EXPECT_LT(mean.se, 0.02 * mean.mean);
  // Layers at the walls leave the pressure along them lower: 1.4 % of the mean in a box of soft particles as
  // short as this, 0.3 % and less in SDPD.
  double const tolerance = settings.features().densities ? 0.005 : 0.02;
  EXPECT_NEAR(felt / mean.mean, 1, tolerance + 4 * mean.se / mean.mean);
}

// The images are what a fluid would have that is its own mirror image: twice the box, periodic, without
// walls.
TEST_P(EveryWalledFluid, IsHalfOfASymmetricOne) {
  auto settings = GetParam().settings;
  settings.scheme.pairs = "ssa";
  MirroredFluid const fluid(settings, {make_system(settings)->walls[0].axis});
  fluid.expect_same(1e-10);
  EXPECT_EQ(fluid.part->size(), 512U);
}

TEST_P(EveryWalledFluid, HasVirialsOfItsParticlesThatMakeThatOfTheWhole) {
  auto const system = make_system(GetParam().settings);
  auto const of_each = virials(*system);
  EXPECT_EQ(of_each.empty(), system->has_densities());
  if (!of_each.empty()) {
    EXPECT_NEAR(std::accumulate(of_each.begin(), of_each.end(), 0.0) / system->virial, 1, 1e-12);
  }
}

TEST(Walls, AreHeldAndLetGo) {
  Simulation simulation(between_walls(ideal_gas(50, 0.02), 0.3));
  simulation.hold_walls(true);
  simulation.advance(10);
  EXPECT_EQ(simulation.wall_time(), 0);
  EXPECT_EQ(simulation.walls()[0].work, 0);
  simulation.hold_walls(false);
  simulation.advance(10);
  EXPECT_NEAR(simulation.wall_time(), 0.2, 1e-12);
  EXPECT_NEAR(simulation.walls()[0].position(simulation.wall_time()), 0.3 * 0.2 * 0.2 / 4, 1e-12);
}

TEST(WallMotion, IsTheIntegralOfItsVelocity) {
  WallMotion const motion{.velocity = 3, .ramp = 2}, at_once{.velocity = 3};
  EXPECT_EQ(motion.velocity_at(-1), 0);
  EXPECT_EQ(motion.velocity_at(1), 1.5);
  EXPECT_EQ(motion.velocity_at(5), 3);
  EXPECT_EQ(motion.way_at(2), 3);
  EXPECT_EQ(motion.way_at(4), 9);
  EXPECT_EQ(at_once.way_at(4), 12);
}

TEST(Walls, ThatCannotBeAreRefused) {
  auto refused = [](auto const& change) {
    auto s = between_walls(ideal_gas(50, 0.02), 0);
    change(s.faces);
    EXPECT_THROW(check(s), InputError);
  };
  EXPECT_NO_THROW(check(between_walls(ideal_gas(50, 0.02), 0)));
  refused([](Faces& faces) { faces[2][0] = {}; });
  refused([](Faces& faces) {
    faces[0] = faces[2], faces[0][0].motion.velocity = faces[2][1].motion.velocity = 1;
  });
  refused([](Faces& faces) { faces[2][0].motion = motion_by_table({{0.1, 1}, {1, 2}}); });
  refused([](Faces& faces) { faces[2][0].motion = motion_by_table({{0, 1}, {1, 2}, {1, 3}}); });
  refused([](Faces& faces) { faces[2][0].motion = motion_by_table({{0, std::nan("")}}); });
  refused([](Faces& faces) { faces[0][0].motion = motion_by_table({{0, 1}}); });
  refused([](Faces& faces) { faces[0][0].motion.velocity = 1; });
  refused([](Faces& faces) { faces[2][0].motion.velocity = std::nan(""); });
  refused([](Faces& faces) { faces[2][0].motion.ramp = -1; });
}

// Vacuum: particles that leave go straight on.
TEST(OpenFaces, LetParticlesGo) {
  auto settings = ideal_gas(50, 0.02);
  settings.lattice = {6, 6, 12};
  for (auto& face : settings.faces[2])
    face.kind = FaceKind::open;
  Simulation simulation(settings);
  auto const before = simulation.observe();
  simulation.advance(400);
  auto const after = simulation.observe();
  double const edge = simulation.box().edge.z;
  int outside = 0;
  for (auto const& q : simulation.snapshot().q)
    outside += q.z < -0.5 * edge || q.z > 1.5 * edge;
  EXPECT_GT(outside, 10);
  EXPECT_LT(norm(after.momentum), 1e-10);
  EXPECT_NEAR(after.energy() / before.energy(), 1, 1e-3);
}

} // namespace
} // namespace mesobridge::sdpd
