#include "fitting/isentrope.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

TEST(Isentrope, OfAnIdealGasIsExact) {
  double const gamma = 1.4;
  Fluid const gas(IdealGas::from_gamma(1, gamma, 1));
  auto const from = gas.at_temperature(1.3, 2);
  Isentrope const isentrope(gas, from);
  int cases = 0;
  for (double const ratio : {1e-6, 0.1, 0.99, 1.0, 3.0, 50.0}) {
    auto const state = isentrope.at_density(ratio * from.rho);
    EXPECT_NEAR(state.P / (from.P * std::pow(ratio, gamma)), 1, 1e-12);
    EXPECT_NEAR(isentrope.at_pressure(state.P).rho / state.rho, 1, 1e-12);
    // Riemann invariant: u + 2 c/(gamma - 1)
    EXPECT_NEAR(isentrope.velocity_change(from.rho, state.rho),
                2 / (gamma - 1) * (*state.sound_speed - *from.sound_speed), 1e-10);
    ++cases;
  }
  EXPECT_EQ(cases, 6);
}

TEST(Isentrope, WorkOfExpansionIsTheLossOfEnergyInEveryModel) {
  int cases = 0;
  for (auto const& [name, rho, T] : {std::tuple{"argon", 1500.0, 900.0},
                                     {"tin", 9000.0, 1000.0},
                                     {"nitromethane", 1500.0, 900.0},
                                     {"nitromethane-products", 1600.0, 4000.0}}) {
    SCOPED_TRACE(name);
    Fluid const fluid(material(name).eos);
    auto const from = fluid.at_temperature(rho, T);
    Isentrope const isentrope(fluid, from);
    // de = -P dv by Simpson's rule along the way
    int const steps = 2000;
    double const v_0 = 1 / rho, v_1 = 1.2 / rho, h = (v_1 - v_0) / steps;
    double work = 0;
    for (int i = 0; i <= steps; ++i)
      work += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * isentrope.at_density(1 / (v_0 + i * h)).P * h / 3;
    auto const to = isentrope.at_density(1 / v_1);
    EXPECT_NEAR((from.e - to.e) / work, 1, 1e-7);
    EXPECT_NEAR(isentrope.at_pressure(to.P).rho / to.rho, 1, 1e-10);
    ++cases;
  }
  EXPECT_EQ(cases, 4);
}

TEST(Isentrope, RefusesTensionBeyondTheStrengthOfTheLiquid) {
  Fluid const argon(material("argon").eos);
  Isentrope const isentrope(argon, argon.at_temperature(1400, 110));
  EXPECT_THROW(isentrope.at_pressure(-1e9), PhysicsError);
  EXPECT_THROW(isentrope.velocity_change(1400, 800), PhysicsError);
  EXPECT_THROW(isentrope.at_pressure(double(NAN)), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
