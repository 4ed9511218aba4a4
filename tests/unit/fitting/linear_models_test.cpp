#include "error_text.hpp"
#include "fitting/fluid.hpp"
#include "fitting/root.hpp"
#include "unit/fitting/built_in.hpp"
#include <array>
#include <functional>
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

double pressure_at(auto const& eos, double rho, double T) {
  return eos.pressure(eos.energy_from_temperature(T, rho), rho);
}

TEST(MieGruneisen, TinHasTheCheckedNumbers) {
  // Independent evaluations of fitting/README.md, Eq. (F4), with the thesis's Table 6.1.
  EXPECT_NEAR(pressure_at(tin(), 7775, 300), 6.71e9, 0.005e9);
  EXPECT_GT(pressure_at(tin(), 6865, 300), 0);
  EXPECT_LT(pressure_at(tin(), 6864, 300), 0);
  // At rho_0: Theta = Theta_0, Gamma = Gamma_0.
  double const e = tin().energy_from_temperature(400, 7000);
  EXPECT_NEAR(tin().gruneisen(e, 7000), 2.8, 1e-12);
  EXPECT_NEAR(tin().entropy(e, 7000), 173 * std::log(400 / (1150 * 0.172)), 1e-10);
}

TEST(MieGruneisen, IsItsPrintedFormula) {
  // s = c_v ln[1 + (e - E_k)/(c_v Theta u_r)] and P = P_k + Gamma rho (e - E_k), written out once more.
  int cases = 0;
  for (double rho : {5000.0, 6930.0, 9000.0})
    for (double T : {250.0, 3000.0}) {
      double const y = 1 - 6930 / rho, n = 6.4, x = 7000 / rho;
      double const E_k = 4.19e10 / 6930 * (std::exp(n * y) / (n * n) - y / n);
      double const P_k = 4.19e10 * (std::exp(n * y) - 1) / n;
      double const Gamma = 0.43 + 2.37 * std::pow(x, 1.96);
      double const Theta =
          1150 * std::pow(rho / 7000, 0.43) * std::exp(2.37 / 1.96 * (1 - std::pow(x, 1.96)));
      double const e = E_k + 173 * (T - 0.172 * Theta);
      EXPECT_NEAR(tin().temperature(e, rho) / T, 1, 1e-12);
      EXPECT_NEAR(tin().entropy(e, rho), 173 * std::log(1 + (e - E_k) / (173 * Theta * 0.172)), 1e-9);
      EXPECT_NEAR(tin().pressure(e, rho), P_k + Gamma * rho * (e - E_k), 1e-12 * 4e10);
      ++cases;
    }
  EXPECT_EQ(cases, 6);
}

TEST(Hz, NitromethaneHasTheCheckedNumbers) {
  EXPECT_NEAR(nitromethane().T_00(), 0.0724, 5e-5);
  EXPECT_NEAR(pressure_at(nitromethane(), 1140, 298.13) / 1e5, 1, 1e-9);
  EXPECT_NEAR(nitromethane().domain().rho_max, 2279.79, 0.01);
}

/// What the Rankine-Hugoniot relations leave over, in units of the energy.
template <class E>
double hugoniot_residual(E const& eos, double rho_0, double T_0, double v_P, double v_S) {
  double const e_0 = eos.energy_from_temperature(T_0, rho_0), P_0 = eos.pressure(e_0, rho_0);
  double const rho = rho_0 * v_S / (v_S - v_P), P = P_0 + rho_0 * v_S * v_P;
  double const e = e_0 + 0.5 * (P_0 + P) * (1 / rho_0 - 1 / rho);
  return eos.pressure(e, rho) / P - 1;
}

TEST(Hz, HasTheCheckedShock) {
  // A value of fitting/README.md, Eq. (F14): 1104 kg/m^3, 300 K, v_P 2500 m/s.
  double const v_S = 6109.9, rho_0 = 1104, v_P = 2500;
  auto const& eos = nitromethane();
  EXPECT_LT(hugoniot_residual(eos, rho_0, 300, v_P, v_S + 0.05) *
                hugoniot_residual(eos, rho_0, 300, v_P, v_S - 0.05),
            0);
  double const e_0 = eos.energy_from_temperature(300, rho_0), P_0 = eos.pressure(e_0, rho_0);
  double const rho = rho_0 * v_S / (v_S - v_P), P = P_0 + rho_0 * v_S * v_P;
  EXPECT_NEAR(rho, 1868.6, 0.05);
  EXPECT_NEAR(P, 16.82e9, 0.005e9);
  EXPECT_NEAR(eos.temperature(e_0 + 0.5 * (P + P_0) * (1 / rho_0 - 1 / rho), rho), 2329, 0.5);
}

TEST(Jwl, ProductsHaveTheCheckedConstants) {
  EXPECT_NEAR(products().K(), -1.7235427e9, 50);
  EXPECT_NEAR(products().C_ek(), -4.6679828e6, 0.05);
  EXPECT_NEAR(products().rho_CJ(), 1568.81, 0.005);
}

TEST(Jwl, PassesThroughItsChapmanJouguetState) {
  auto const& p = products().parameters();
  double const rho = products().rho_CJ(), e = p.E_0 + 0.5 * p.P_CJ * (1 / p.rho_0 - 1 / rho);
  EXPECT_NEAR(products().temperature(e, rho) / p.T_CJ, 1, 1e-12);
  EXPECT_NEAR(products().pressure(e, rho) / p.P_CJ, 1, 1e-12);
}

/// Le Metayer, Massoni, Saurel, Int. J. Therm. Sci. 43 (2004) 265: liquid water without covolume.
StiffenedGas plain_water() {
  return StiffenedGas({.gamma = 2.35, .P_inf = 1e9, .c_v = 1816, .q = -1.167e6, .m0 = 18.015 * atomic_mass});
}

TEST(StiffenedGas, IsTheTextbookLaw) {
  auto const water = plain_water();
  double const rho = 1100, T = 350, e = water.energy_from_temperature(T, rho);
  double const P = water.pressure(e, rho);
  EXPECT_NEAR(P, 1.35 * rho * (e + 1.167e6) - 2.35e9, 1e-12 * 1e9);
  EXPECT_NEAR(water.sound_speed(e, rho), std::sqrt(2.35 * (P + 1e9) / rho), 1e-9);
  EXPECT_NEAR(water.gruneisen(e, rho), 1.35, 1e-12);
}

TEST(StiffenedGas, WithCovolumeIsTheLawOfNobleAndAbel) {
  auto const& water = std::get<StiffenedGas>(material("water").eos);
  double const rho = 1100, T = 350, v = 1 / rho, b = 6.7212e-4, e = water.energy_from_temperature(T, rho);
  EXPECT_NEAR(e, -1177788 + 3610 * T + 6.2178e8 * (v - b), 1e-6);
  double const P = water.pressure(e, rho);
  EXPECT_NEAR(P, 0.19 * (e + 1177788) / (v - b) - 1.19 * 6.2178e8, 1e-3);
  EXPECT_NEAR(water.sound_speed(e, rho), std::sqrt(1.19 * v * v * (P + 6.2178e8) / (v - b)), 1e-8);
  EXPECT_NEAR(water.entropy(water.energy_from_temperature(400, 1000), 1000) - water.entropy(e, rho),
              3610 * (std::log(400 / T) + 0.19 * std::log((1e-3 - b) / (v - b))), 1e-8);
}

TEST(Water, IsAtAtmosphericPressureAtRoomTemperature) {
  Fluid const water(material("water").eos);
  auto const room = water.at_temperature(997, 300);
  EXPECT_NEAR(room.P, 1e5, 5e4);
  EXPECT_NEAR(room.sound_speed.value(), 1500, 1);
  // Measured densities (IAPWS): 999.9 kg/m^3 at 280 K, 973.7 at 350 K, 1037 at 300 K and 100 MPa.
  int compared = 0;
  for (auto const& [T, P, rho] :
       {std::array{280.0, 1e5, 999.9}, std::array{350.0, 1e5, 973.7}, std::array{300.0, 1e8, 1037.0}}) {
    double const found =
        bracketed_zero([&](double at) { return water.at_temperature(at, T).P - P; }, 900.0, 1200.0);
    EXPECT_NEAR(found / rho, 1, 0.03);
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

TEST(StiffenedGas, WithoutStiffnessIsTheIdealGas) {
  IdealGas const ideal(1e-25);
  StiffenedGas const same({.gamma = 5.0 / 3, .P_inf = 0, .c_v = 1.5 * k_B / 1e-25, .q = 0, .m0 = 1e-25});
  double const rho = 1150, e = 3e5;
  EXPECT_NEAR(same.pressure(e, rho) / ideal.pressure(e, rho), 1, 1e-14);
  EXPECT_NEAR(same.temperature(e, rho) / ideal.temperature(e, rho), 1, 1e-14);
  EXPECT_NEAR(same.sound_speed(e, rho) / ideal.sound_speed(e, rho), 1, 1e-14);
  auto entropy_change = [&](auto const& eos) { return eos.entropy(2 * e, 3 * rho) - eos.entropy(e, rho); };
  EXPECT_NEAR(entropy_change(same) / entropy_change(ideal), 1, 1e-12);
}

/// Every parameter of a model, set to NaN, infinity and a few wrong numbers.
template <class Model, class Parameters>
int refused(Parameters good, std::vector<std::pair<double Parameters::*, std::vector<double>>> const& bad) {
  int count = 0;
  EXPECT_NO_THROW(Model{good});
  for (auto const& [member, values] : bad) {
    auto all = values;
    all.insert(all.end(), {NAN, INFINITY});
    for (double value : all) {
      Parameters spoilt = good;
      spoilt.*member = value;
      EXPECT_THROW(Model{spoilt}, InputError) << value;
      ++count;
    }
  }
  return count;
}

TEST(LinearModels, BadParametersAreRefused) {
  using M = MieGruneisenParameters;
  EXPECT_EQ((refused<MieGruneisen, M>(tin_parameters, {{&M::Gamma_0, {0, -1}},
                                                       {&M::Gamma_inf, {-0.1}},
                                                       {&M::q, {0}},
                                                       {&M::rho_0, {0}},
                                                       {&M::Theta_0, {-1}},
                                                       {&M::u_r, {0}},
                                                       {&M::c_v, {0}},
                                                       {&M::rho_s, {-1}},
                                                       {&M::K_s, {0}},
                                                       {&M::N_s, {-1}},
                                                       {&M::m0, {0}}})),
            34);
  using H = HzParameters;
  EXPECT_EQ((refused<Hz, H>(nitromethane_parameters, {{&H::Gamma_0, {0}},
                                                      {&H::rho_0, {0}},
                                                      {&H::c_0, {-1}},
                                                      {&H::s, {-1}},
                                                      {&H::c_v, {0}},
                                                      {&H::T_0, {0, 0.07}},
                                                      {&H::P_0, {1e12}},
                                                      {&H::m0, {-1}}})),
            25);
  using J = JwlParameters;
  EXPECT_EQ((refused<Jwl, J>(nitromethane_products_parameters, {{&J::Gamma_0, {0}},
                                                                {&J::rho_0, {0}},
                                                                {&J::E_0, {}},
                                                                {&J::D_CJ, {0}},
                                                                {&J::P_CJ, {-1, 5e10}},
                                                                {&J::T_CJ, {0}},
                                                                {&J::c_v, {0}},
                                                                {&J::a, {}},
                                                                {&J::b, {}},
                                                                {&J::R_1, {0}},
                                                                {&J::R_2, {-1}},
                                                                {&J::m0, {0}}})),
            34);
  using S = StiffenedGasParameters;
  EXPECT_EQ(
      (refused<StiffenedGas, S>(
          water_parameters,
          {{&S::gamma, {1}}, {&S::P_inf, {-1}}, {&S::c_v, {0}}, {&S::q, {}}, {&S::m0, {0}}, {&S::b, {-1}}})),
      17);
}

void expect_named(std::string const& what, std::vector<std::string> const& parts) {
  for (auto const& part : parts)
    EXPECT_NE(what.find(part), std::string::npos) << what;
}

TEST(LinearModels, StatesOutsideAreRefusedByName) {
  expect_named(tests::error_text<PhysicsError>([] { nitromethane().pressure(1e6, 2280); }),
               {"HZ", "density 2280", "2279.7"});
  double const coldest = products().law(1500.0).E;
  EXPECT_NO_THROW(products().pressure(coldest + 1, 1500));
  expect_named(tests::error_text<PhysicsError>([&] { products().pressure(coldest - 1, 1500); }),
               {"JWL", "1500", "energy", "T = 0"});
  expect_named(tests::error_text<PhysicsError>([] { tin().isochore(1e-200); }),
               {"Mie-Gruneisen", "1e-200", "too extreme"});
  expect_named(tests::error_text<PhysicsError>([] { tin().energy_from_temperature(-1, 7000); }),
               {"temperature -1", "7000"});
  // Cold products pull themselves together (K < 0): there is no sound in expansion.
  double const e = products().energy_from_temperature(300, 100);
  EXPECT_LT(products().pressure(e, 100), 0);
  expect_named(tests::error_text<PhysicsError>([&] { products().sound_speed(e, 100); }),
               {"mechanically unstable", "density 100", "temperature 300"});
}

} // namespace
} // namespace mesobridge::fitting::test
