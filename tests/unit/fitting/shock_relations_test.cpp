#include "fitting/shock_relations.hpp"
#include "unit/fitting/random_states.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::fitting::test {
namespace {

Fluid fluid(std::string const& name) {
  return Fluid(material(name).eos);
}

/// A gas of k_B/m0 = 1, so that P = rho T.
struct Gas {
  double gamma;
  Fluid fluid{IdealGas::from_gamma(1, gamma, 1)};
  EosState state(double rho, double P) const { return fluid.at_energy(rho, P / ((gamma - 1) * rho)); }
};

struct Jump {
  double v_S, rho, P, T;
};

void expect_jump(Shock const& found, Jump const& expected, double tolerance) {
  EXPECT_NEAR(found.v_S / expected.v_S, 1, tolerance);
  EXPECT_NEAR(found.behind.rho / expected.rho, 1, tolerance);
  EXPECT_NEAR(found.behind.P / expected.P, 1, tolerance);
  EXPECT_NEAR(found.behind.T / expected.T, 1, tolerance);
}

TEST(Hugoniot, GivesTheValuesOfAnIndependentSolver) {
  // The values beside fitting/README.md, Eq. (F14); the first two also in the thesis's Tables 5.2 and 4.2.
  auto const from_piston = [](std::string const& name, double rho, double T, double v_P) {
    return Hugoniot(fluid(name), fluid(name).at_temperature(rho, T)).from_piston(v_P);
  };
  expect_jump(from_piston("argon", 1150, 500, 500), {1975.0, 1539.8, 1.4661e9, 968.9}, 1e-4);
  expect_jump(from_piston("ideal-gas", 1150, 1000, 1661), {2314.1, 4074.7, 4.579e9, 8139}, 1e-4);
  expect_jump(from_piston("nitromethane", 1104, 300, 2500), {6109.9, 1868.6, 16.82e9, 2329}, 2e-4);
}

TEST(Hugoniot, OfAnIdealGasIsExact) {
  int cases = 0;
  for (double const gamma : {1.1, 1.4, 5.0 / 3})
    for (double const M : {1.0001, 1.5, 3.0, 30.0}) {
      Gas const gas{gamma};
      auto const ahead = gas.state(1.3, 0.7);
      auto const found = Hugoniot(gas.fluid, ahead).from_speed(M * *ahead.sound_speed);
      EXPECT_NEAR(found.behind.P / (0.7 * (1 + 2 * gamma / (gamma + 1) * (M * M - 1))), 1, 1e-12);
      EXPECT_NEAR(found.behind.rho / (1.3 * (gamma + 1) * M * M / ((gamma - 1) * M * M + 2)), 1, 1e-12);
      ++cases;
    }
  EXPECT_EQ(cases, 12);
}

/// How far mass, momentum and energy are from being conserved across a shock, relative to their sizes.
double violation(Shock const& s, double q) {
  auto const& [a, b, v_S, v_P] = s;
  double const mass = b.rho * (v_S - v_P) / (a.rho * v_S) - 1;
  double const momentum = (b.P - a.P) / (a.rho * v_S * v_P) - 1;
  double const heat = b.e - a.e - q - 0.5 * (a.P + b.P) * (1 / a.rho - 1 / b.rho);
  double const scale = 0.5 * (std::abs(a.P) + b.P) * (1 / a.rho - 1 / b.rho) + std::abs(b.e) + std::abs(a.e);
  return std::max({std::abs(mass), std::abs(momentum), std::abs(heat) / scale});
}

struct Range {
  std::string material;
  double rho_min, rho_max, T_min, T_max, v_P_max;
};

TEST(Hugoniot, TheFourWaysToAShockAgreeAndConserveInEveryModel) {
  // States with a sound speed, from weak shocks to strong ones inside the model.
  std::vector<Range> const ranges{
      {"argon", 1150, 1400, 200, 1500, 700},        {"lj", 0.7, 1.0, 1.5, 10, 4},
      {"ideal-gas", 1, 5000, 10, 1e4, 1e5},         {"tin", 6800, 9000, 300, 3000, 3000},
      {"nitromethane", 1104, 1300, 250, 500, 5000}, {"nitromethane-products", 500, 1500, 2000, 4000, 5000},
      {"water", 950, 1200, 280, 400, 5000},
  };
  std::mt19937_64 generator(3);
  auto const uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  int cases = 0;
  double worst_balance = 0, worst_agreement = 0;
  for (auto const& range : ranges)
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE(range.material);
      Fluid const matter = fluid(range.material);
      auto const ahead =
          matter.at_temperature(uniform(range.rho_min, range.rho_max), uniform(range.T_min, range.T_max));
      Hugoniot const hugoniot(matter, ahead);
      auto const s = hugoniot.from_piston(range.v_P_max * std::pow(1e-3, uniform(0, 1)));
      worst_balance = std::max(worst_balance, violation(s, 0));
      EXPECT_GT(s.behind.s, ahead.s);
      EXPECT_GT(s.v_S, *ahead.sound_speed);
      EXPECT_LT(s.v_S - s.v_P, *s.behind.sound_speed);
      for (auto const& other : {hugoniot.from_speed(s.v_S), hugoniot.from_pressure(s.behind.P),
                                hugoniot.from_density(s.behind.rho)}) {
        // A weak shock's strength is the small difference of what is given and what is ahead.
        double const strength = s.v_P / s.v_S;
        worst_agreement = std::max({worst_agreement, strength * std::abs(other.v_P / s.v_P - 1),
                                    std::abs(other.v_S / s.v_S - 1) * strength,
                                    std::abs(other.behind.rho / s.behind.rho - 1),
                                    std::abs(other.behind.T / s.behind.T - 1)});
      }
      EXPECT_NEAR(hugoniot.rayleigh_pressure(s.v_S, s.behind.rho) / s.behind.P, 1, 1e-7);
      ++cases;
    }
  std::printf("%d shocks; largest violation of a balance %.1e, disagreement of two ways %.1e\n", cases,
              worst_balance, worst_agreement);
  EXPECT_EQ(cases, 280);
  EXPECT_LT(worst_balance, 1e-7);
  EXPECT_LT(worst_agreement, 1e-9);
}

TEST(Hugoniot, AnyStateOfAnyModelHasAShockOrARefusal) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::size_t models = 0;
  for (auto const& [name, description, eos, usable] : materials()) {
    Fluid const matter(eos);
    int shocks = 0, refusals = 0;
    double worst = 0;
    constexpr int trials = 300;
    for (int i = 0; i < trials; ++i) {
      auto const [rho, T] = std::visit([&](auto const& e) { return random_state(e, generator); }, eos);
      auto const ahead = matter.at_temperature(rho, T);
      double const v_P = 10 * std::sqrt(ahead.T * matter.gas_constant()) * std::pow(1e-4, uniform(generator));
      try {
        auto const s = Hugoniot(matter, ahead).from_piston(v_P);
        worst = std::max(worst, violation(s, 0) * s.v_P / s.v_S);
        EXPECT_GE(s.behind.s, ahead.s - 1e-8 * (std::abs(ahead.s) + ahead.c_v));
        ++shocks;
      } catch (PhysicsError const&) {
        ++refusals;
      }
    }
    std::printf("%s: %d shocks (largest violation of a balance %.1e), %d refusals\n", name.c_str(), shocks,
                worst, refusals);
    EXPECT_EQ(shocks + refusals, trials);
    EXPECT_GT(shocks, trials / 2);
    EXPECT_LT(worst, 1e-9);
    ++models;
  }
  EXPECT_EQ(models, materials().size());
}

TEST(Hugoniot, TheWeakestShocksAreSound) {
  Fluid const argon = fluid("argon");
  auto const ahead = argon.at_temperature(1150, 500);
  int cases = 0;
  for (double v_P = 1; v_P > 1e-10; v_P *= 0.1) {
    auto const s = Hugoniot(argon, ahead).from_piston(v_P);
    EXPECT_NEAR(s.v_S / *ahead.sound_speed, 1, 3 * v_P / *ahead.sound_speed + 1e-12 / v_P);
    ++cases;
  }
  EXPECT_GE(cases, 10);
}

TEST(Hugoniot, ItsCurveRisesFromTheInitialState) {
  Hugoniot const argon(fluid("argon"), fluid("argon").at_temperature(1150, 500));
  auto const curve = argon.curve(5e9, 30);
  ASSERT_EQ(curve.size(), 30u);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    EXPECT_GT(curve[i].behind.rho, curve[i - 1].behind.rho);
    EXPECT_GT(curve[i].behind.T, curve[i - 1].behind.T);
    EXPECT_GT(curve[i].v_S, curve[i - 1].v_S);
  }
  EXPECT_NEAR(curve.back().behind.P, 5e9, 1);
}

TEST(Hugoniot, RefusesWhatIsNoShock) {
  auto const argon = fluid("argon");
  Hugoniot const hugoniot(argon, argon.at_temperature(1150, 500));
  EXPECT_THROW(hugoniot.from_piston(0), InputError);
  EXPECT_THROW(hugoniot.from_piston(-1), InputError);
  EXPECT_THROW(hugoniot.from_piston(double(NAN)), InputError);
  EXPECT_THROW(hugoniot.from_speed(900), PhysicsError);    // slower than sound
  EXPECT_THROW(hugoniot.from_pressure(1e8), PhysicsError); // below that ahead
  EXPECT_THROW(hugoniot.from_density(1100), PhysicsError);
  EXPECT_THROW(hugoniot.from_density(1e5), PhysicsError);
  try {
    hugoniot.from_piston(1e5);
    FAIL() << "no exception";
  } catch (PhysicsError const& error) {
    EXPECT_NE(std::string(error.what()).find("v_P = 100000"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("outside the model"), std::string::npos) << error.what();
  }
  // Beyond the greatest compression (gamma + 1)/(gamma - 1) = 4.
  Gas const gas{5.0 / 3};
  EXPECT_THROW(Hugoniot(gas.fluid, gas.state(1, 1)).from_density(4.001), PhysicsError);
  EXPECT_NO_THROW(Hugoniot(gas.fluid, gas.state(1, 1)).from_density(3.999));
  // Inside the liquid-gas region.
  EXPECT_THROW(Hugoniot(argon, argon.at_temperature(500, 110)), PhysicsError);
}

TEST(ChapmanJouguet, OfAnIdealGasIsExact) {
  // For products with the gamma of the reactant, D/c_0 = sqrt(H + 1) + sqrt(H), H = (gamma^2 - 1) q/(2
  // c_0^2).
  int cases = 0;
  for (double const gamma : {1.2, 1.4, 3.0})
    for (double const q : {0.3, 5.0, 500.0}) {
      Gas const gas{gamma};
      auto const ahead = gas.state(1.3, 0.7);
      Hugoniot const crussard(ahead, gas.fluid, q);
      auto const cj = crussard.chapman_jouguet();
      double const c_2 = ahead.sound_speed_squared, H = (gamma * gamma - 1) * q / (2 * c_2);
      double const D = std::sqrt(c_2) * (std::sqrt(H + 1) + std::sqrt(H));
      EXPECT_NEAR(cj.v_S / D, 1, 1e-12);
      // P_CJ = (P_0 + rho_0 D^2)/(gamma + 1)
      EXPECT_NEAR(cj.behind.P / ((0.7 + 1.3 * D * D) / (gamma + 1)), 1, 1e-9);
      auto const checks = crussard.check(cj);
      EXPECT_NEAR(checks.tangency, 0, 1e-6);
      EXPECT_GT(checks.neighbours, 0);
      ++cases;
    }
  EXPECT_EQ(cases, 9);
}

Hugoniot nitromethane_crussard(double rho, double q, std::optional<double> P_0 = std::nullopt) {
  auto ahead = fluid("nitromethane").at_temperature(rho, 300);
  ahead.P = P_0.value_or(ahead.P);
  return {ahead, fluid("nitromethane-products"), q};
}

TEST(ChapmanJouguet, OfNitromethaneIsThatOfAnIndependentSolver) {
  // The value beside fitting/README.md, Eq. (F15), at zero pressure ahead.
  auto const crussard = nitromethane_crussard(1104, 4.716e6, 0);
  auto const cj = crussard.chapman_jouguet();
  expect_jump(cj, {6757, 1578.6, 15.15e9, 4882}, 2e-4);
  EXPECT_LT(violation(cj, 4.716e6), 1e-9);
  auto const checks = crussard.check(cj);
  EXPECT_NEAR(checks.tangency, 0, 1e-6);
  EXPECT_GT(checks.neighbours, 0);
  // The products' own calibration, Table 6.3: no further heat.
  EXPECT_NEAR(nitromethane_crussard(1128, 0, 0).chapman_jouguet().v_S, 6280, 1);
  // The thesis prints 6620 m/s, which is the answer for another heat of reaction.
  EXPECT_NEAR(nitromethane_crussard(1104, 3.52e6, 0).chapman_jouguet().v_S, 6620, 1);
}

TEST(ChapmanJouguet, IsTheSlowestDetonation) {
  auto const crussard = nitromethane_crussard(1104, 4.716e6);
  auto const cj = crussard.chapman_jouguet();
  EXPECT_THROW(crussard.from_speed(cj.v_S - 1), PhysicsError);
  EXPECT_THROW(crussard.from_piston(cj.v_P - 10), PhysicsError);
  auto const driven = crussard.from_speed(cj.v_S + 50);
  EXPECT_GT(driven.behind.P, cj.behind.P); // the strong solution
  EXPECT_LT(violation(driven, 4.716e6), 1e-9);
  EXPECT_NEAR(crussard.from_piston(driven.v_P).v_S / driven.v_S, 1, 1e-9);
  EXPECT_NEAR(crussard.from_pressure(driven.behind.P).v_S / driven.v_S, 1, 1e-9);
  EXPECT_NEAR(crussard.from_density(driven.behind.rho).v_S / driven.v_S, 1, 1e-9);
  auto const curve = crussard.curve(3e10, 100);
  double least = curve.front().v_S;
  for (auto const& point : curve)
    least = std::min(least, point.v_S);
  EXPECT_GE(least, cj.v_S * (1 - 1e-12));
  EXPECT_NEAR(least / cj.v_S, 1, 1e-4);
}

TEST(ChapmanJouguet, IsRefusedWhereThereIsNone) {
  Gas const gas{1.4};
  EXPECT_THROW(Hugoniot(gas.state(1, 1), gas.fluid, double(NAN)), InputError);
  EXPECT_THROW(Hugoniot(gas.state(1, 1), gas.fluid, -100.0).chapman_jouguet(), PhysicsError);
}

} // namespace
} // namespace mesobridge::fitting::test
