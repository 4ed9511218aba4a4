#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

Scene argon(double eta, std::string const& piston) {
  return parse_scene(fmt::format(R"(title = "a piston"
units = "SI"
[fluid]
eos = "argon"
rho = "1150 kg/m^3"
T = "500 K"
[particles]
N = 980
K = 100
density = "plain"
[box]
lattice = [7, 7, 20]
z = "walls"
piston = "{}"
ramp = "1 ps"
[transport]
eta = "{} Pa*s"
[scheme]
dt = 0.02
[run]
steps = 100
)",
                                 piston, eta),
                     "piston.toml");
}

std::optional<double> Re_l(Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  auto const shock = shock_before_piston(settings);
  return shock ? std::optional(front_reynolds_number(settings, *shock)) : std::nullopt;
}

/// The texts of what is said of ripples.
std::vector<std::string> told(Scene const& scene) {
  std::vector<std::string> texts;
  for (auto const& doubt : doubts_about(scene, settings_of(scene, 1)))
    if (doubt.name == "ripples")
      texts.push_back(doubt.text);
  return texts;
}

TEST(FrontReynoldsNumber, IsThatOfTheMeanDistance) {
  // By hand: 1975.0 m/s by the relations of Rankine and Hugoniot, l = (100 6.64e-26/1150)^(1/3) m.
  double const l = std::cbrt(100 * 6.64e-26 / 1150);
  auto const Re = Re_l(argon(1e-4, "500 m/s"));
  ASSERT_TRUE(Re);
  EXPECT_NEAR(*Re / (1150 * 1975.0 * l / (4e-4 / 3)), 1, 1e-4);
  EXPECT_NEAR(*Re, 31, 0.5);
  EXPECT_NEAR(*Re_l(argon(2e-3, "500 m/s")) / *Re, 1e-4 / 2e-3, 1e-12);
  EXPECT_FALSE(Re_l(argon(1e-4, "-500 m/s")));
}

TEST(FrontReynoldsNumber, IsWarnedOfAboveTwo) {
  auto const rough = told(argon(1e-4, "500 m/s"));
  ASSERT_EQ(rough.size(), 1u);
  EXPECT_NE(rough[0].find("Re_l = rho_0 v_S l/(4 eta/3 + zeta) = 30.6"), std::string::npos) << rough[0];
  EXPECT_NE(rough[0].find("transport.eta >= 0.0015"), std::string::npos) << rough[0];
  EXPECT_EQ(told(argon(1.4e-3, "500 m/s")).size(), 1u); // 2.2
  EXPECT_TRUE(told(argon(1.6e-3, "500 m/s")).empty());  // 1.9
  EXPECT_TRUE(told(argon(1e-4, "-500 m/s")).empty());
}

} // namespace
} // namespace mesobridge::workflows
