#include "fitting/eos/list.hpp"
#include "fitting/predict_data.hpp"
#include "unit/fitting/synthetic_eos_data.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

Hz const nitromethane(nitromethane_parameters);
Jwl const products(nitromethane_products_parameters);
MieGruneisen const tin(tin_parameters);

TEST(PredictData, ShockOfNitromethaneIsTheIndependentOne) {
  Observation const shock{.path = DataPath::hugoniot,
                          .start = StartState{.rho = 1104, .T = 300},
                          .given = {{Quantity::v_P, 2500}}};
  auto const state = reach(nitromethane, shock, 0);
  EXPECT_NEAR(state.v_S, 6109.9, 0.1);
  EXPECT_NEAR(state.rho, 1868.6, 0.1);
  EXPECT_NEAR(state.P / 1e9, 16.82, 0.01);
  EXPECT_NEAR(state.T, 2329, 1);
  EXPECT_EQ(state.v_P, 2500);
}

TEST(PredictData, DetonationsOfTheProductsAreTheIndependentOnes) {
  // By its own calibration, and from liquid nitromethane at 1104 kg/m^3 and 300 K with q = 4.716 MJ/kg at P =
  // 0.
  auto const own =
      reach(products, {.path = DataPath::cj, .start = StartState{.rho = 1128, .e = 0.0, .P = 0.0}}, 0);
  EXPECT_NEAR(own.v_S, 6280, 3);
  // D is flat at its minimum: the printed P_CJ only comes near it.
  EXPECT_NEAR(own.rho, products.rho_CJ(), 6);
  StartState const start{.rho = 1104, .e = nitromethane.isochore(1104.0).energy(300) + 4.716e6, .P = 0.0};
  auto const cj = reach(products, {.path = DataPath::cj, .start = start}, 0);
  EXPECT_NEAR(cj.v_S, 6757, 1);
  EXPECT_NEAR(cj.rho, 1578.6, 0.3);
  EXPECT_NEAR(cj.P / 1e9, 15.15, 0.01);
  EXPECT_NEAR(cj.T, 4882, 2);
}

TEST(PredictData, TheFourWaysToAShockAgreeAndFulfilTheJumpConditions) {
  int cases = 0;
  auto const run = [&](auto const& model, double rho_0, double T_0, double v_P) {
    auto const isochore = model.isochore(rho_0);
    double const e_0 = isochore.energy(T_0), P_0 = isochore.pressure(T_0);
    LinearHugoniot const shocks(model, rho_0, e_0, P_0);
    auto const a = shocks.at_piston(v_P);
    EXPECT_NEAR(a.rho * (a.v_S - a.v_P) / (rho_0 * a.v_S), 1, 1e-12);
    EXPECT_NEAR((a.P - P_0) / (rho_0 * a.v_S * a.v_P), 1, 1e-10);
    EXPECT_NEAR((a.e - e_0) / (0.5 * (a.P + P_0) * (1 / rho_0 - 1 / a.rho)), 1, 1e-10);
    EXPECT_NEAR(model.pressure(a.e, a.rho) / a.P, 1, 1e-10);
    for (auto const& b : {shocks.at_density(a.rho), shocks.at_speed(a.v_S), shocks.at_pressure(a.P)}) {
      EXPECT_NEAR(b.rho / a.rho, 1, 1e-9);
      EXPECT_NEAR(b.T / a.T, 1, 1e-8);
      EXPECT_NEAR(b.v_P / a.v_P, 1, 1e-8);
      ++cases;
    }
  };
  for (double const v_P : {50.0, 500.0, 2000.0, 5000.0}) {
    run(tin, 7290, 300, v_P);
    run(nitromethane, 1125, 300, v_P);
    run(products, 1128, 2000, v_P);
  }
  EXPECT_EQ(cases, 36);
}

TEST(PredictData, IsentropesKeepTheirEntropyAndEnergyFollowsTheWork) {
  StartState const start{.rho = 1568.81, .P = 1.25e10};
  auto const at = [&](double rho) {
    return reach(products, {.path = DataPath::isentrope, .start = start, .given = {{Quantity::rho, rho}}}, 0);
  };
  EXPECT_NEAR(at(1568.81).P / 1.25e10, 1, 1e-12);
  int cases = 0;
  for (double const rho : {1400.0, 700.0, 100.0, 10.0}) {
    // de = -P dv along it, by differences
    double const h = 1e-4 * rho;
    double const slope = (at(rho + h).e - at(rho - h).e) / (1 / (rho + h) - 1 / (rho - h));
    EXPECT_NEAR(-slope / at(rho).P, 1, 1e-6);
    ++cases;
  }
  EXPECT_EQ(cases, 4);
}

TEST(PredictData, EnergiesMayHaveAZeroOfTheirOwn) {
  double const offset = 3e5;
  Observation const by_T{.given = {{Quantity::rho, 8000}, {Quantity::T, 900}}};
  auto const state = reach(tin, by_T, 0);
  EXPECT_EQ(quantity_of(tin, state, Quantity::e, offset), state.e + offset);
  Observation const by_e{.given = {{Quantity::rho, 8000}, {Quantity::e, state.e + offset}}};
  EXPECT_NEAR(reach(tin, by_e, offset).T, 900, 1e-9);
  // A shock from a stated energy does not notice the zero either.
  Observation const by_density{.path = DataPath::hugoniot,
                               .start =
                                   StartState{.rho = 7290, .e = tin.isochore(7290.0).energy(300) + offset},
                               .given = {{Quantity::v_P, 1000}}};
  Observation const same{.path = DataPath::hugoniot,
                         .start = StartState{.rho = 7290, .T = 300},
                         .given = {{Quantity::v_P, 1000}}};
  EXPECT_NEAR(reach(tin, by_density, offset).v_S / reach(tin, same, 0).v_S, 1, 1e-12);
}

TEST(PredictData, RefusesWhatTheModelDoesNotReach) {
  LinearHugoniot const shocks(tin, 7290, tin.isochore(7290.0).energy(300),
                              tin.isochore(7290.0).pressure(300));
  EXPECT_THROW(shocks.at_speed(1000), PhysicsError);    // below the sound speed
  EXPECT_THROW(shocks.at_pressure(-1e9), PhysicsError); // no compression
  EXPECT_THROW(shocks.at_density(7000), PhysicsError);
  EXPECT_THROW(shocks.at_density(1e5), PhysicsError); // beyond one shock's greatest compression
  EXPECT_THROW(temperature_from_pressure(tin, -1e11, 7290), PhysicsError);
}

TEST(PredictData, SystematicErrorsAreFractionsOfTheValuesOrTheirSpread) {
  std::vector<Observation> data(3);
  for (std::size_t i = 0; i < 3; ++i) {
    double const x = static_cast<double>(i);
    data[i].measured = {{Quantity::P, 1e9 * x, 1}, {Quantity::e, 7e6 + 1e5 * x, 1}, {Quantity::v_S, 3000, 1}};
  }
  add_systematic_errors(data, 0.1);
  // 0, 1, 2 have the standard deviation 1.
  EXPECT_NEAR(data[0].measured[0].systematic, 1e8, 1);
  EXPECT_NEAR(data[2].measured[0].systematic, 2e8, 1);
  EXPECT_NEAR(data[0].measured[1].systematic, 1e4, 1e-3);
  EXPECT_NEAR(data[0].measured[2].systematic, 300, 1e-9);
  EXPECT_THROW(add_systematic_errors(data, 1), InputError);
  EXPECT_THROW(add_systematic_errors(data, NAN), InputError);
}

TEST(PredictData, IncompleteObservationsAreRefusedByTheirOrigin) {
  Datum const P{Quantity::P, 1e9, 1e7}, rho{Quantity::rho, 8000}, T{Quantity::T, 300};
  struct Case {
    Observation observation;
    std::string words;
  };
  std::vector<Case> const cases{
      {{.given = {rho}, .measured = {P}}, "a state needs rho and T"},
      {{.given = {rho, T}, .measured = {}}, "nothing was measured"},
      {{.given = {{Quantity::rho, -1}, T}, .measured = {P}}, "rho = -1: must be > 0"},
      {{.given = {rho, T}, .measured = {{Quantity::P, 1e9, 0}}}, "standard error of P = 0"},
      {{.given = {rho, T}, .measured = {{Quantity::P, NAN, 1}}}, "P = nan: must be finite"},
      {{.given = {rho, T}, .measured = {P}, .P_e_correlation = 1}, "P_e_correlation = 1"},
      {{.path = DataPath::hugoniot, .given = {rho}, .measured = {P}}, "need the density of their start"},
      {{.path = DataPath::hugoniot, .start = StartState{7290}, .given = {rho}, .measured = {P}},
       "one of T0, e0, P0"},
      {{.path = DataPath::hugoniot, .start = StartState{7290, 300}, .given = {T}, .measured = {P}},
       "one of rho, v_P"},
      {{.path = DataPath::isentrope, .start = StartState{7290, 300}, .given = {T}, .measured = {P}},
       "needs rho"},
      {{.path = DataPath::cj, .start = StartState{7290, 300}, .measured = {P}}, "e0 and P0"},
  };
  int ran = 0;
  for (auto [observation, words] : cases) {
    observation.origin = "tin.csv:7";
    try {
      check(observation);
      ADD_FAILURE() << words;
    } catch (InputError const& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("tin.csv:7: ")) << error.what();
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
    ++ran;
  }
  EXPECT_EQ(ran, 11);
}

} // namespace
} // namespace mesobridge::fitting::test
