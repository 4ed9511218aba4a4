#include "cg/estimate.hpp"
#include "pair_fluid_fixtures.hpp"
#include "same_bits.hpp"
#include "sdpd/boundary/wall_friction.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/system/conservation.hpp"
#include "sdpd/system/total_energy.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

struct Case {
  std::string name;
  SimulationSettings settings;
};

/// Rough walls without a bath, of which the upper one slides.
SimulationSettings adiabatic(SimulationSettings s, double slide = 0.5) {
  s.lattice = {8, 8, 8};
  s.disorder = 0.2;
  s.faces = walls_along(2);
  for (auto& face : s.faces[2])
    face.friction = {.acts = true, .temperature = s.T, .bath = false};
  s.faces[2][1].friction.slide.x = slide * s.units().velocity();
  return s;
}

std::vector<Case> fluids() {
  return {{"ideal_gas", adiabatic(ideal_gas(20, 0.02))},
          {"argon", adiabatic(argon(20, 0.02))},
          {"conducting_argon", adiabatic(with_conduction(argon(20, 0.02), 0.5))},
          {"dpde", adiabatic(dpde_fluid(20, 0.01, 2))}};
}

class EveryAdiabaticWall : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Fluids, EveryAdiabaticWall, ::testing::ValuesIn(fluids()),
                         [](auto const& info) { return info.param.name; });

TEST_P(EveryAdiabaticWall, GivesWorkAloneToRoundOff) {
  auto const system = make_system(GetParam().settings);
  auto const list = sub_steps(GetParam().settings.scheme, *system, GetParam().settings.dt);
  int seen = 0;
  double balance = 0, work = 0;
  for (int k = 0; k < 50; ++k, ++system->step)
    for (auto const& part : list) {
      bool const rubs = part.name == "friction and heat of the walls";
      double const before = total_energy(*system), done = system->wall_work();
      ASSERT_NO_THROW(run_and_check(part, *system));
      if (rubs) {
        ++seen, work += std::abs(system->wall_work() - done);
        balance += std::abs(total_energy(*system) - before - (system->wall_work() - done));
      }
    }
  EXPECT_EQ(seen, 50);
  EXPECT_GT(work, 1e-3);
  EXPECT_LT(balance, 1e-12 * std::abs(total_energy(*system)) * seen);
  for (auto const& wall : system->walls)
    EXPECT_EQ(wall.heat, 0);
  EXPECT_EQ(system->walls[0].work, 0); // it is at rest
  EXPECT_GT(std::abs(system->walls[0].drag.x), 0);
}

TEST_P(EveryAdiabaticWall, HasTheSameBitsOnAnyNumberOfThreadsAndAfterARestart) {
  expect_same_bits_and_gains(GetParam().settings);
}

// A particle that stays in place shares its energy E in the wall's frame between its motion and its heat by
// (S17): the motion's share has the law Beta(3/2, a) with a = C/k_B + 1 for DPDE, and C/k_B for SDPD's
// exp(S/k_B)/T, whatever the time step.
TEST(AdiabaticWall, LeavesTheInvariantMeasureAlone) {
  for (bool const sdpd : {true, false})
    for (double const dt : {0.05, 1.0, 4000.0}) {
      constexpr double K = 10;
      auto s = adiabatic(sdpd ? ideal_gas(K, 0.02) : dpde_fluid(K), 0.3);
      if (sdpd)
        s.as<Sdpd>().centre_of_mass = CentreOfMass::free;
      auto const system = make_system(s);
      auto const part = wall_friction(*system, dt, false);
      auto const& wall = system->walls[1];
      double const C = 1 / system->particles.caloric[0].inverse_C_0 / system->boltzmann;
      double const a = sdpd ? C : C + 1;
      std::vector<double> shares, squares;
      int const steps = dt < 1 ? 12000 : 3000;
      for (; system->step < static_cast<std::uint64_t>(steps); ++system->step) {
        part.run(*system);
        double share = 0, square = 0;
        int near = 0;
        for (Index const i : wall.layer.particles) {
          if (wall.distance(system->particles.q[i], 0) > 0.4)
            continue;
          double const motion = 0.5 * norm2(system->particles.p[i] - wall_velocity(*system, wall));
          double const x = motion / (motion + system->particles.eps[i]);
          share += x, square += x * x, ++near;
        }
        ASSERT_GT(near, 10);
        shares.push_back(share / near), squares.push_back(square / near);
      }
      std::size_t const settled = shares.size() / 6;
      auto const mean = cg::estimate_mean(std::span(shares).subspan(settled)),
                 mean_square = cg::estimate_mean(std::span(squares).subspan(settled));
      double const expected = 1.5 / (1.5 + a), expected_square = expected * 2.5 / (2.5 + a);
      EXPECT_TRUE(cg::agrees(mean, expected, 4))
          << sdpd << dt << " " << mean.mean << " " << mean.se << " " << expected;
      EXPECT_TRUE(cg::agrees(mean_square, expected_square, 4)) << sdpd << dt;
      EXPECT_LT(mean.se, 0.02 * expected) << sdpd << dt;
      EXPECT_FALSE(cg::agrees(mean, 1.5 / (1.5 + a + (sdpd ? 1 : -1)), 4)) << sdpd << dt;
    }
}

// Couette's flow between such walls heats the fluid by the work of the sliding wall, to the drift of the
// integrator, and leaves the rest at rest.
TEST(AdiabaticWall, HeatsTheFluidByItsWork) {
  auto s = adiabatic(ideal_gas(50, 0.01), 2);
  Simulation simulation(s);
  auto const before = simulation.observe();
  simulation.advance(800);
  auto const after = simulation.observe();
  EXPECT_EQ(after.given, after.wall_work);
  EXPECT_GT(after.wall_work / before.kinetic, 0.3);
  double const gain = after.internal + after.kinetic - before.internal - before.kinetic;
  EXPECT_NEAR(gain / after.wall_work, 1, 0.02);
}

TEST(AdiabaticWall, ThatCannotBeIsRefused) {
  EXPECT_NO_THROW(check(adiabatic(ideal_gas(50, 0.02))));
  EXPECT_THROW(check(adiabatic(dpd_fluid())), InputError);
  auto s = ideal_gas(50, 0.02);
  s.lattice = {8, 8, 8}, s.faces = walls_along(2), s.faces[2][0].friction.bath = false;
  EXPECT_THROW(check(s), InputError);
  s = adiabatic(ideal_gas(50, 0.02)), s.faces[2][1].friction.slide_ramp = -1;
  EXPECT_THROW(check(s), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
