#include "fitting/eos/ideal_gas.hpp"
#include "fitting/eos/list.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

TEST(IdealGas, ObeysTheGasLaw) {
  IdealGas const gas(1e-25);
  double const rho = 1150, T = 1000, R = k_B / 1e-25;
  double const e = gas.energy_from_temperature(T, rho);
  EXPECT_DOUBLE_EQ(e, 1.5 * R * T);
  EXPECT_DOUBLE_EQ(gas.pressure(e, rho), rho * R * T);
  EXPECT_DOUBLE_EQ(gas.heat_capacity(e, rho), 1.5 * R);
  EXPECT_DOUBLE_EQ(gas.sound_speed(e, rho), std::sqrt(5.0 / 3 * R * T));
  EXPECT_DOUBLE_EQ(gas.entropy(e, rho), 1.5 * R * std::log(e) - R * std::log(rho));
}

TEST(IdealGas, HasTheExactHugoniotOfGammaFiveThirds) {
  // A value of fitting/README.md, Eq. (F14): 1150 kg/m^3, 1000 K, v_P 1661 m/s; strong-shock relations are
  // exact for an ideal gas.
  IdealGas const gas(1e-25);
  double const rho_0 = 1150, v_S = 2314.1, v_P = 1661;
  double const e_0 = gas.energy_from_temperature(1000, rho_0), P_0 = gas.pressure(e_0, rho_0);
  double const rho_1 = rho_0 * v_S / (v_S - v_P), P_1 = P_0 + rho_0 * v_S * v_P;
  double const e_1 = e_0 + 0.5 * (P_0 + P_1) * (1 / rho_0 - 1 / rho_1);
  EXPECT_NEAR(rho_1, 4074.7, 0.5);
  EXPECT_NEAR(gas.pressure(e_1, rho_1) / P_1, 1, 1e-4);
  EXPECT_NEAR(gas.temperature(e_1, rho_1), 8139, 1);
}

TEST(IdealGas, TakesGammaInsteadOfDegreesOfFreedom) {
  auto const diatomic = IdealGas::from_gamma(4.65e-26, 1.4);
  EXPECT_NEAR(diatomic.dof(), 5, 1e-12);
  EXPECT_NEAR(diatomic.gamma(), 1.4, 1e-15);
  EXPECT_NEAR(diatomic.pressure(2e5, 1.2), 0.4 * 1.2 * 2e5, 1e-9);
}

TEST(IdealGas, RefusesNonsense) {
  int refused = 0;
  for (double bad : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    EXPECT_THROW(IdealGas{bad}, InputError);
    EXPECT_THROW(IdealGas(1e-25, bad), InputError);
    EXPECT_THROW(IdealGas(1e-25, 3, bad), InputError);
    EXPECT_THROW(IdealGas::from_gamma(1e-25, bad), InputError);
    ++refused;
  }
  EXPECT_EQ(refused, 4);
}

TEST(Materials, AreFoundByNameOnly) {
  EXPECT_EQ(material("argon").name, "argon");
  EXPECT_TRUE(
      material_names().starts_with("argon, lj, ideal-gas, tin, nitromethane, nitromethane-products, "));
  EXPECT_TRUE(material_names().ends_with(", water, air, lj-kn, lj-thol"));
  try {
    material("argonn");
    FAIL() << "no exception";
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("argon, lj, ideal-gas"), std::string::npos);
  }
}

} // namespace
} // namespace mesobridge::fitting::test
