#include "pair_fluid_fixtures.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

TEST(MotionTable, IsLinearBetweenItsRowsAndKeepsTheLast) {
  auto const motion = motion_by_table({{0, 1}, {2, 3}, {3, -1}, {5, 0.5}});
  EXPECT_EQ(motion.velocity_at(-1), 0);
  EXPECT_EQ(motion.velocity_at(0), 0); // it has not begun
  EXPECT_NEAR(motion.velocity_at(1e-12), 1, 1e-9);
  EXPECT_NEAR(motion.velocity_at(1), 2, 1e-15);
  EXPECT_NEAR(motion.velocity_at(2.75), 0, 1e-15);
  EXPECT_NEAR(motion.velocity_at(9), 0.5, 1e-15);
  double way = 0;
  int compared = 0;
  constexpr double step = 1e-3; // the midpoint rule is exact
  for (; compared < 12000; ++compared) {
    double const t = step * compared;
    ASSERT_NEAR(motion.way_at(t), way, 1e-9) << t;
    way += step * motion.velocity_at(t + step / 2);
  }
  EXPECT_EQ(compared, 12000);
}

TEST(MotionTable, DrivesAShockWhereItOnlyBecomesFaster) {
  EXPECT_EQ(motion_by_table({{0, 0}, {1, 2}, {2, 5}}).driving_velocity(), 5);
  EXPECT_EQ(motion_by_table({{0, 0}, {1, 2}, {2, 1}}).driving_velocity(), 0);
  EXPECT_EQ(motion_by_table({{0, -1}, {1, 2}}).driving_velocity(), 0);
  EXPECT_EQ((WallMotion{.velocity = 3}.driving_velocity()), 3);
  EXPECT_EQ((WallMotion{.velocity = -3}.driving_velocity()), 0);
}

SimulationSettings before_piston(SimulationSettings s, WallMotion motion) {
  s.lattice = {6, 6, 10};
  s.disorder = 0.2;
  s.faces = walls_along(2, motion);
  return s;
}

TEST(MotionTable, ThatIsTheRampGivesItsRun) {
  for (auto const& s : {ideal_gas(50, 0.02), dpde_fluid(40, 0.01, 2)}) {
    double const v = 0.4 * s.units().velocity(), ramp = 0.7 * s.units().time();
    Simulation by_ramp(before_piston(s, {.velocity = v, .ramp = ramp})),
        by_table(before_piston(s, motion_by_table({{0, 0}, {ramp, v}})));
    by_ramp.advance(100), by_table.advance(100);
    auto const a = by_ramp.snapshot(), b = by_table.snapshot();
    for (std::size_t i = 0; i < a.q.size(); ++i)
      EXPECT_LT(norm(a.q[i] - b.q[i]), 1e-9);
    EXPECT_GT(by_ramp.walls()[0].work, 0.1);
    EXPECT_NEAR(by_table.walls()[0].work / by_ramp.walls()[0].work, 1, 1e-9);
    EXPECT_NEAR(by_table.observe().P / by_ramp.observe().P, 1, 1e-9);
  }
}

TEST(MotionTable, BalancesMomentumToRoundOffAndEnergyByTheWork) {
  auto const s = ideal_gas(50, 0.01);
  double const v = 0.3 * s.units().velocity(), t = s.units().time();
  Simulation simulation(before_piston(s, motion_by_table({{0, v}, {0.5 * t, -v}, {1 * t, 2 * v}})));
  auto const before = simulation.observe();
  simulation.advance(200);
  auto const after = simulation.observe();
  Vec3 impulse;
  for (auto const& wall : simulation.walls())
    component(impulse, wall.axis) += wall.impulse;
  double const scale = std::sqrt(2 * before.kinetic * static_cast<double>(simulation.size()));
  EXPECT_LT(norm(after.momentum - before.momentum - impulse) / scale, 1e-12);
  EXPECT_GT(after.wall_work / before.kinetic, 0.2);
  EXPECT_LT(std::abs(after.energy() - before.energy()), 4e-3 * after.wall_work);
}

// An ideal gas that is compressed slowly, by a piston that starts and stops gently, stays on its isentrope:
// e goes as rho^(2/3), and the work is what it gains.
TEST(MotionTable, CompressesSlowlyAlongTheIsentrope) {
  auto s = ideal_gas(50, 0.05);
  s.lattice = {6, 6, 12}, s.disorder = 0, s.noise = false;
  auto const units = s.units();
  double const edge = box_of(s).edge.z, way = 0.2 * edge, v = 0.05; // the speed of sound is about 1.3
  double const ramp = 20, hold = way / v - ramp;
  s.faces = walls_along(2, motion_by_table({{0, 0},
                                            {ramp * units.time(), v * units.velocity()},
                                            {(ramp + hold) * units.time(), v * units.velocity()},
                                            {(2 * ramp + hold) * units.time(), 0}}));
  Simulation simulation(s);
  auto const before = simulation.observe();
  simulation.advance(static_cast<std::uint64_t>((2 * ramp + hold + 20) / s.dt));
  auto const after = simulation.observe();
  EXPECT_NEAR(simulation.walls()[0].position(simulation.wall_time()), way, 1e-9);
  double const isentrope = std::pow(1 / 0.8, 2.0 / 3);
  // By 0.5 %: friction of the flow heats it a little.
  EXPECT_NEAR(after.internal / before.internal / isentrope, 1, 0.005);
  EXPECT_NEAR(after.P / before.P / std::pow(1 / 0.8, 5.0 / 3), 1,
              0.02); // by the virial of a flattened lattice
  EXPECT_NEAR((after.internal + after.kinetic - before.internal - before.kinetic) / after.wall_work, 1, 1e-3);
}

/// The velocity at z between walls that are 0 and L apart at the time t, when the one at L has come to the
/// velocity U in the time ramp: the start of Couette's flow by its sine series, and Duhamel's integral.
double starting_couette(double z, double t, double L, double U, double ramp, double nu) {
  double sum = z / L;
  for (int n = 1; n < 200; ++n) {
    double const k = n * std::numbers::pi / L, rate = nu * k * k;
    double const left = (std::exp(-rate * (t - ramp)) - std::exp(-rate * t)) / (rate * ramp);
    sum += 2 * (n % 2 ? -1 : 1) / (n * std::numbers::pi) * std::sin(k * z) * left;
  }
  return U * sum;
}

// Without noise, a viscous ideal gas follows the exact start of Couette's flow with its ramp.
TEST(SlidingWall, StartsCouettesFlowByItsRamp) {
  auto s = ideal_gas(100, 0.05);
  s.as<Sdpd>().kernel = "wendland-c4";
  s.as<Sdpd>().eta = s.units().viscosity();
  s.lattice = {6, 6, 16}, s.disorder = 0, s.noise = false;
  double const U = 0.2, ramp = 10;
  s.faces = walls_along(2);
  double const strength = usual_wall_friction(s);
  for (auto& face : s.faces[2])
    face.friction = {.acts = true, .temperature = s.T, .strength = strength};
  s.faces[2][1].friction.slide.x = U * s.units().velocity();
  s.faces[2][1].friction.slide_ramp = ramp * s.units().time();
  Simulation simulation(s);
  int compared = 0;
  double largest = 0;
  for (double const t : {15.0, 30.0, 60.0}) {
    simulation.advance(static_cast<std::uint64_t>(std::llround((t - simulation.wall_time()) / s.dt)));
    auto const now = simulation.snapshot();
    double const L = simulation.box().edge.z;
    for (std::size_t i = 0; i < now.q.size(); ++i, ++compared) {
      double const exact = starting_couette(now.q[i].z, t, L, U, ramp, 1);
      EXPECT_NEAR(now.p[i].x, exact, 0.04 * U) << t << " " << now.q[i].z;
      largest = std::max(largest, now.p[i].x);
    }
  }
  EXPECT_EQ(compared, 3 * 576);
  EXPECT_GT(largest, 0.8 * U);
}

} // namespace
} // namespace mesobridge::sdpd
