#include "fitting/eos/list.hpp"
#include "fitting/fluid.hpp"
#include "fitting/predict_data.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

Davis const products(pbx_9502_products_parameters);

TEST(Davis, IsItsPrintedFormula) {
  // Wescott, Stewart and Davis 2005, with powers written out.
  double const a = 0.798311, b = 0.58, k = 1.35, n = 2.66182, v_c = 7.5419e-4, p_c = 3.2e9, c_v = 1072;
  int cases = 0;
  for (double const rho : {50.0, 900.0, 1.0 / v_c, 1890.0, 2600.0})
    for (double const T : {300.0, 3500.0}) {
      double const V = 1 / (rho * v_c), M = 0.5 * (std::pow(V, n) + std::pow(V, -n));
      double const F = 2 * a * std::pow(V, -n) / (std::pow(V, n) + std::pow(V, -n));
      double const p_s = p_c * std::pow(M, a / n) / std::pow(V, k + a) * (k - 1 + F) / (k - 1 + a);
      double const e_s = p_c * v_c / (k - 1 + a) * std::pow(M, a / n) / std::pow(V, k - 1 + a);
      double const T_s = std::pow(2, -a * b / n) / (k - 1 + a) * p_c * v_c / c_v *
                         std::pow(M, a / n * (1 - b)) / std::pow(V, k - 1 + a * (1 - b));
      double const e = e_s + c_v * (T - T_s);
      EXPECT_NEAR(products.energy_from_temperature(T, rho) / e, 1, 1e-12);
      EXPECT_NEAR(products.pressure(e, rho), p_s + (k - 1 + (1 - b) * F) * rho * (e - e_s),
                  1e-12 * p_s + 1e-3);
      EXPECT_NEAR(products.gruneisen(e, rho), k - 1 + (1 - b) * F, 1e-12);
      ++cases;
    }
  EXPECT_EQ(cases, 10);
}

TEST(Davis, DetonatesAsPbx9502Does) {
  // 7.80 km/s and 28.5 GPa: the Chapman-Jouguet state that the set was made for, from 1890 kg/m^3 with the
  // heat of detonation of 4.115 MJ/kg.
  auto const cj =
      reach(products, {.path = DataPath::cj, .start = StartState{.rho = 1890, .e = 4.115e6, .P = 0.0}}, 0);
  EXPECT_NEAR(cj.v_S, 7800, 10);
  EXPECT_NEAR(cj.P, 28.5e9, 0.05e9);
}

TEST(Davis, ThinProductsAreAnIdealGas) {
  auto const thin = Fluid(products).at_temperature(1e-3, 2000);
  EXPECT_NEAR(thin.e / (1072 * 2000), 1, 1e-3);
  EXPECT_NEAR(thin.P / (0.35 * 1e-3 * 1072 * 2000), 1, 1e-3);
  EXPECT_NEAR(*thin.sound_speed / std::sqrt(1.35 * thin.P / 1e-3), 1, 1e-3);
}

TEST(Davis, AGammaThatTurnsNegativeIsRefused) {
  auto spoilt = pbx_9502_products_parameters;
  spoilt.b = 1.3;
  EXPECT_THROW(Davis{spoilt}, InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
