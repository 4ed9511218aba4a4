#include "piston_text.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

Scene argon(double eta, double v_P, std::string const& scheme = "dt = 0.02", int steps = 100) {
  return parse_scene(tests::piston_text({.v_P = v_P,
                                         .box = "ramp = \"1 ps\"",
                                         .eta = fmt::format("{} Pa*s", eta),
                                         .scheme = scheme,
                                         .run = fmt::format("steps = {}", steps)}),
                     "piston.toml");
}

std::optional<double> Re_l(Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  auto const shock = shock_before_piston(settings);
  return shock ? std::optional(front_reynolds_number(settings, *shock)) : std::nullopt;
}

/// The texts of what is said of ripples, or of what else goes by that name.
std::vector<std::string> told(Scene const& scene, std::string const& name = "ripples") {
  std::vector<std::string> texts;
  for (auto const& doubt : doubts_about(scene, settings_for_check(scene, 1)))
    if (doubt.name == name)
      texts.push_back(doubt.text);
  return texts;
}

TEST(FrontReynoldsNumber, IsThatOfTheMeanDistance) {
  // By hand: 1975.0 m/s by the relations of Rankine and Hugoniot, l = (100 6.64e-26/1150)^(1/3) m.
  double const l = std::cbrt(100 * 6.64e-26 / 1150);
  auto const Re = Re_l(argon(1e-4, 500));
  ASSERT_TRUE(Re);
  EXPECT_NEAR(*Re / (1150 * 1975.0 * l / (4e-4 / 3)), 1, 1e-4);
  EXPECT_NEAR(*Re, 31, 0.5);
  EXPECT_NEAR(*Re_l(argon(2e-3, 500)) / *Re, 1e-4 / 2e-3, 1e-12);
  EXPECT_FALSE(Re_l(argon(1e-4, -500)));
}

TEST(FrontReynoldsNumber, IsWarnedOfAboveTwo) {
  auto const rough = told(argon(1e-4, 500));
  ASSERT_EQ(rough.size(), 1u);
  EXPECT_NE(rough[0].find("Re_l = rho_0 v_S l/(4 eta/3 + zeta) = 30.6"), std::string::npos) << rough[0];
  EXPECT_NE(rough[0].find("transport.eta >= 0.0015"), std::string::npos) << rough[0];
  EXPECT_EQ(told(argon(1.4e-3, 500)).size(), 1u); // 2.2
  EXPECT_TRUE(told(argon(1.6e-3, 500)).empty());  // 1.9
  EXPECT_TRUE(told(argon(1e-4, -500)).empty());
}

/// By hand: 20 spacings at 1975.0 m/s and half of the ramp.
TEST(FarWall, IsWarnedOfWhereTheShockComesToIt) {
  double const l = std::cbrt(100 * 6.64e-26 / 1150), unit = l * std::sqrt(6.64e-26 / (1.380649e-23 * 500)),
               steps = (20 * l / 1975.0 + 0.5e-12) / (0.02 * unit);
  EXPECT_NEAR(*steps_to_far_wall(settings_of(argon(2e-3, 500), 1)) / steps, 1, 1e-4);
  EXPECT_TRUE(told(argon(2e-3, 500, "dt = 0.02", int(steps) - 2), "reflection").empty());
  auto const late = told(argon(2e-3, 500, "dt = 0.02", int(steps) + 2), "reflection");
  ASSERT_EQ(late.size(), 1u);
  EXPECT_NE(late[0].find(fmt::format("after about {:.0f} of run.steps = {}", steps, int(steps) + 2)),
            std::string::npos)
      << late[0];
  EXPECT_TRUE(told(argon(2e-3, -500, "dt = 0.02", 1000), "reflection").empty());
  auto const automatic = told(argon(2e-3, 500, "dt = \"auto\"\ndrift = \"1%\"", 100), "reflection");
  ASSERT_EQ(automatic.size(), 1u);
  EXPECT_NE(automatic[0].find("the largest that dt = \"auto\" may choose"), std::string::npos);
}

/// The same way for a table as for the ramp that it is.
TEST(FarWall, IsReachedByTheWayOfTheTable) {
  auto const ramped = argon(2e-3, 500);
  auto table = ramped;
  table.box.piston = table.box.ramp = std::nullopt;
  table.box.piston_times = {0, 1e-12}, table.box.piston_velocities = {0, 500};
  EXPECT_NEAR(*steps_to_far_wall(settings_of(table, 1)) / *steps_to_far_wall(settings_of(ramped, 1)), 1,
              1e-12);
}

} // namespace
} // namespace mesobridge::workflows
