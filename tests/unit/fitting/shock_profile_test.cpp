#include "fitting/shock_profile.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

/// x of the velocity w (in the shock's frame, against the direction of travel) in the exact profiles
///   mu w w' = m A (w - w_0)(w - w_1),
/// of an ideal gas, with A = (gamma + 1)/(2 gamma) when kappa = mu c_p (Becker, Z. Phys. 8 (1922) 321) and
/// A = (gamma + 1)/2 without conduction, counted from w = (w_0 + w_1)/2.
struct ExactProfile {
  double w_0, w_1, length; // length = mu/(m A)

  double x(double w) const {
    auto const primitive = [&](double v) { return w_0 * std::log(w_0 - v) - w_1 * std::log(v - w_1); };
    return -length / (w_0 - w_1) * (primitive(w) - primitive(0.5 * (w_0 + w_1)));
  }
};

void compare_with_exact(double gamma, double M, bool conducting) {
  Fluid const gas(IdealGas::from_gamma(1, gamma, 1));
  auto const ahead = gas.at_temperature(1, 1);
  auto const shock = Hugoniot(gas, ahead).from_speed(M * *ahead.sound_speed);
  Transport transport{.shear_viscosity = 0.6, .bulk_viscosity = 0.25};
  double const mu = 4.0 / 3 * transport.shear_viscosity + transport.bulk_viscosity;
  double const c_p = gamma / (gamma - 1);
  transport.conductivity = conducting ? mu * c_p : 0; // Prandtl number 3/4 when zeta = 0
  auto const profile = shock_profile(gas, shock, transport);
  double const A = conducting ? (gamma + 1) / (2 * gamma) : (gamma + 1) / 2;
  ExactProfile const exact{shock.v_S, shock.v_S - shock.v_P, mu / (ahead.rho * shock.v_S * A)};
  double worst = 0;
  int compared = 0;
  for (auto const& point : profile.points) {
    if (point.v < 1e-5 * shock.v_P || point.v > (1 - 1e-5) * shock.v_P)
      continue; // x diverges logarithmically at the ends
    // -x: the exact profile is given along the flow
    worst = std::max(worst, std::abs(-point.x + exact.x(shock.v_S - point.v)) / profile.thickness);
    ++compared;
  }
  std::printf("gamma %.3f, M %.1f, %s: %d of %zu points compared, largest error %.1e of the thickness\n",
              gamma, M, conducting ? "Becker" : "no conduction", compared, profile.points.size(), worst);
  EXPECT_GT(compared, 100);
  EXPECT_LT(worst, 1e-8);
}

TEST(ShockProfile, IsBeckersAndTheAdiabaticOneInAnIdealGas) {
  int cases = 0;
  for (double const gamma : {1.4, 5.0 / 3})
    for (double const M : {1.1, 2.0, 6.0})
      for (bool const conducting : {true, false}) {
        compare_with_exact(gamma, M, conducting);
        ++cases;
      }
  EXPECT_EQ(cases, 12);
}

TEST(ShockProfile, FluxesAreConstantAndTheEndsAreHugoniotStates) {
  int cases = 0;
  for (double const conductivity : {0.0, 0.05, 0.3}) {
    Fluid const argon(material("argon").eos);
    auto const ahead = argon.at_temperature(1150, 500);
    auto const shock = Hugoniot(argon, ahead).from_piston(500);
    Transport const transport{.shear_viscosity = 1e-4, .bulk_viscosity = 5e-5, .conductivity = conductivity};
    auto const profile = shock_profile(argon, shock, transport);
    auto const& points = profile.points;
    double const mu = 4e-4 / 3 + 5e-5, m = ahead.rho * shock.v_S;
    double const momentum_0 = m * shock.v_S + ahead.P;
    double const energy_0 = m * (ahead.e + 0.5 * shock.v_S * shock.v_S) + ahead.P * shock.v_S;
    double worst_mass = 0, worst_momentum = 0, worst_energy = 0;
    // Slopes by differences of fourth order over the equally spaced points, not by the equations themselves.
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
      double const h = points[i + 1].x - points[i].x;
      auto const slope = [&](auto&& value) {
        return (8 * (value(points[i + 1]) - value(points[i - 1])) -
                (value(points[i + 2]) - value(points[i - 2]))) /
               (12 * h);
      };
      double const v_x = slope([](auto const& p) { return p.v; });
      double const T_x = slope([](auto const& p) { return p.state.T; });
      auto const& s = points[i].state;
      double const w = shock.v_S - points[i].v, stress = s.P - mu * v_x; // w' along the flow is v' along x
      worst_mass = std::max(worst_mass, std::abs(s.rho * w / m - 1));
      worst_momentum = std::max(worst_momentum, std::abs(m * w + stress - momentum_0));
      worst_energy = std::max(worst_energy,
                              std::abs(m * (s.e + 0.5 * w * w) + stress * w + conductivity * T_x - energy_0));
    }
    double const jump = shock.behind.P - ahead.P;
    std::printf(
        "conductivity %.2f: %zu points, thickness %.3e m; fluxes: mass %.1e, momentum %.1e, energy %.1e\n",
        conductivity, points.size(), profile.thickness, worst_mass, worst_momentum / jump,
        worst_energy / (jump * shock.v_S));
    EXPECT_LT(worst_mass, 1e-10);
    EXPECT_LT(worst_momentum / jump, 1e-7);
    EXPECT_LT(worst_energy / (jump * shock.v_S), 1e-7);
    EXPECT_NEAR(points.front().state.rho / shock.behind.rho, 1, 1e-5);
    EXPECT_NEAR(points.front().state.T / shock.behind.T, 1, 1e-5);
    EXPECT_NEAR(points.back().state.rho / ahead.rho, 1, 1e-5);
    EXPECT_NEAR(points.back().state.T / ahead.T, 1, 1e-5);
    EXPECT_TRUE(std::ranges::is_sorted(points, {}, &ProfilePoint::x));
    EXPECT_TRUE(std::ranges::is_sorted(points, std::greater{}, &ProfilePoint::v));
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

TEST(ShockProfile, IsAsWideAsTheViscosity) {
  Fluid const argon(material("argon").eos);
  auto const shock = Hugoniot(argon, argon.at_temperature(1150, 500)).from_piston(500);
  auto const thin = shock_profile(argon, shock, {.shear_viscosity = 1e-4});
  auto const wide = shock_profile(argon, shock, {.shear_viscosity = 3e-4});
  EXPECT_NEAR(wide.thickness / thin.thickness, 3, 1e-3);
}

TEST(ShockProfile, RefusesBadCoefficients) {
  Fluid const argon(material("argon").eos);
  auto const shock = Hugoniot(argon, argon.at_temperature(1150, 500)).from_piston(500);
  EXPECT_THROW(shock_profile(argon, shock, {.shear_viscosity = 0}), InputError);
  EXPECT_THROW(shock_profile(argon, shock, {.shear_viscosity = -1}), InputError);
  EXPECT_THROW(shock_profile(argon, shock, {.shear_viscosity = double(NAN)}), InputError);
  EXPECT_THROW(shock_profile(argon, shock, {.shear_viscosity = 1e-4, .conductivity = -1}), InputError);
  EXPECT_THROW(shock_profile(argon, shock, {.shear_viscosity = 1e-4}, 0.5), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
