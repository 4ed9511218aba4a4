#include "md/lj_piston.hpp"
#include "piston_slices.hpp"
#include "temporary_log.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::md::test {
namespace {

LjPistonSettings small_settings() {
  LjPistonSettings settings;
  settings.cells_across = 3, settings.cells_along = 30;
  settings.cutoff = 2.5;
  settings.equilibration_steps = 600;
  settings.sample_every = 50;
  settings.log_file = tests::temporary_log("piston");
  return settings;
}

TEST(LjPiston, PushesAFluidThatIsAtRestFurtherOn) {
  auto const settings = small_settings();
  auto const all = slices_of(sample_lj_piston, settings, 800);
  ASSERT_EQ(all.size(), 16u);
  for (auto const& now : all) {
    ASSERT_EQ(now.number.size(), std::size_t(settings.slices()));
    EXPECT_NEAR(std::accumulate(now.number.begin(), now.number.end(), 0.0), double(settings.atoms()), 1);
    EXPECT_NEAR(now.piston, settings.v_P * double(now.step) * settings.dt, 1e-12);
  }
  // By the relations of Rankine and Hugoniot with Kolafa and Nezbeda's equation: the front at 12.37 x 1.6
  // = 19.8, the piston at 5.1; behind it T* = 7.86, P* = 34.6. Slices are 1.135 wide.
  auto const& last = all.back();
  EXPECT_NEAR(mean(last, last.velocity, 7, 14), settings.v_P, 0.35);
  EXPECT_NEAR(mean(last, last.velocity, 26, 42), 0, 0.25);
  EXPECT_NEAR(mean(last, last.T, 7, 14), 7.86, 1.0);
  EXPECT_NEAR(mean(last, last.T, 26, 42), settings.ahead.T, 0.9);
  EXPECT_NEAR(mean(last, last.P, 7, 14), 34.6, 6);
}

/// Before the piston comes the fluid has the pressure of its equation of state: Kolafa and Nezbeda's 7.42 at
/// rho* = 0.6837, T* = 4.166, less the tail beyond 4 sigma, -16/3 pi rho^2 (1/64)(...) = 0.12.
TEST(LjPiston, BeginsInTheStateAhead) {
  auto settings = small_settings();
  settings.cutoff = 4, settings.cells_along = 40, settings.sample_every = 10;
  auto const all = slices_of(sample_lj_piston, settings, 60);
  double P = 0, T = 0;
  for (auto const& now : all)
    P += mean(now, now.P, 15, 40) / double(all.size()), T += mean(now, now.T, 15, 40) / double(all.size());
  EXPECT_NEAR(T, settings.ahead.T, 0.25);
  EXPECT_NEAR(P, 7.86, 0.7);
}

TEST(LjPiston, IsRefusedByName) {
  MpiWorld const world;
  auto settings = small_settings();
  settings.cells_along = 5;
  EXPECT_THROW(sample_lj_piston(world, settings, 100, {}), InputError);
  settings = small_settings(), settings.v_P = -1;
  EXPECT_THROW(sample_lj_piston(world, settings, 100, {}), InputError);
  settings = small_settings(), settings.ahead.T = std::nan("");
  EXPECT_THROW(check(settings), InputError);
}

} // namespace
} // namespace mesobridge::md::test
