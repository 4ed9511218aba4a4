#include "fitting/eos/list.hpp"
#include "fitting/eos/mixture.hpp"
#include "unit/fitting/built_in.hpp"
#include <chrono>
#include <ctime>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace mesobridge::fitting::test {
namespace {

Mixture<Hz, Jwl> explosive(VolumeLaw law = VolumeLaw::additive_volume) {
  return {nitromethane(), products(), law};
}

struct Trial {
  double lambda, rho, e;
};

/// From all over: traces of either part, dilute to dense, below the cold curves to hot products.
Trial random_trial(std::mt19937_64& generator) {
  auto const uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  double const trace = std::pow(10, uniform(-15, 0)), kind = uniform(0, 4);
  return {.lambda = kind < 1   ? trace
                    : kind < 2 ? 1 - trace
                               : uniform(0, 1),
          .rho = uniform(0, 1) < 0.5 ? uniform(800, 2200) : std::pow(10, uniform(0, 3.3)),
          .e = uniform(-2e6, 1e7)};
}

/// How far a state is from being the stated one, by the pure models: volumes, energies, pressures.
template <class A, class B>
double violation(Mixture<A, B> const& mixture, Trial const& t, MixtureState const& s) {
  auto const reactant = mixture.reactant().isochore(s.rho_reactant);
  auto const product = mixture.product().isochore(s.rho_product);
  bool const additive = mixture.law() == VolumeLaw::additive_volume;
  double const volumes = (1 - t.lambda) / s.rho_reactant + t.lambda / s.rho_product;
  double const densities = (1 - t.lambda) * s.rho_reactant + t.lambda * s.rho_product;
  double const e_0 = reactant.energy(s.T), e_1 = product.energy(s.T);
  double const energy = (1 - t.lambda) * e_0 + t.lambda * e_1 - t.e;
  double const stiffness = s.rho_reactant * reactant.pressure_density_slope(s.T) +
                           s.rho_product * product.pressure_density_slope(s.T);
  return std::max({std::abs((additive ? volumes * t.rho : densities / t.rho) - 1),
                   std::abs(energy) / (std::abs(e_0) + std::abs(e_1)),
                   std::abs(reactant.pressure(s.T) - s.P) / stiffness,
                   std::abs(product.pressure(s.T) - s.P) / stiffness});
}

/// Answers or refusals of many random states.
void check_random_states(VolumeLaw law, int states) {
  auto const mixture = explosive(law);
  std::mt19937_64 generator(11);
  std::map<std::string, int> refusals;
  int answers = 0;
  double worst = 0;
  auto const start = std::clock();
  for (int i = 0; i < states; ++i) {
    auto const trial = random_trial(generator);
    try {
      auto const s = mixture.state(trial.lambda, trial.rho, trial.e);
      worst = std::max(worst, violation(mixture, trial, s));
      ASSERT_GT(s.T, 0);
      ASSERT_GT(s.c_v, 0);
      ASSERT_TRUE(std::isfinite(s.sound_speed_squared) && std::isfinite(s.s));
      ++answers;
    } catch (PhysicsError const& error) {
      std::string const what = error.what();
      ASSERT_NE(what.find("mixture of progress"), std::string::npos) << what;
      ++refusals[what.substr(what.find(": ") + 2, 20)];
    }
  }
  double const microseconds = 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC / states;
  int refused = 0;
  for (auto const& [why, count] : refusals) {
    std::printf("  %d refused: %s...\n", count, why.c_str());
    refused += count;
  }
  std::printf("%s volumes: %d states, %d answered (largest violation %.1e), %d refused; %.0f us each\n",
              law == VolumeLaw::paper ? "paper's" : "additive", states, answers, worst, refused,
              microseconds);
  EXPECT_EQ(answers + refused, states);
  EXPECT_GT(answers, states / 3);
  EXPECT_LT(worst, 1e-10);
  EXPECT_LE(refusals.size(), 4u); // nothing but the reasons that the model knows
}

TEST(Mixture, AnswersOrRefusesEveryState) {
  check_random_states(VolumeLaw::additive_volume, 1000);
  check_random_states(VolumeLaw::paper, 500);
}

TEST(Long_Mixture, AnswersOrRefusesAMillionStates) {
  check_random_states(VolumeLaw::additive_volume, 1000000);
  check_random_states(VolumeLaw::paper, 100000);
}

TEST(Mixture, ItsEndsAreThePureModels) {
  int cases = 0;
  for (auto const law : {VolumeLaw::additive_volume, VolumeLaw::paper}) {
    auto const mixture = explosive(law);
    double const rho = 1500, e_0 = nitromethane().energy_from_temperature(1500, rho),
                 e_1 = products().energy_from_temperature(3500, rho);
    auto const reactant = mixture.state(0, rho, e_0), product = mixture.state(1, rho, e_1);
    EXPECT_DOUBLE_EQ(reactant.P, nitromethane().pressure(e_0, rho));
    EXPECT_DOUBLE_EQ(product.P, products().pressure(e_1, rho));
    EXPECT_DOUBLE_EQ(std::sqrt(reactant.sound_speed_squared), nitromethane().sound_speed(e_0, rho));
    EXPECT_DOUBLE_EQ(std::sqrt(product.sound_speed_squared), products().sound_speed(e_1, rho));
    EXPECT_DOUBLE_EQ(product.c_v, products().heat_capacity(e_1, rho));
    EXPECT_DOUBLE_EQ(product.s, products().entropy(e_1, rho));
    // Traces of the other part change nothing: the limits are continuous.
    for (double const trace : {1e-9, 1e-15, 1e-300}) {
      auto const nearly_0 = mixture.state(trace, rho, e_0), nearly_1 = mixture.state(1 - trace, rho, e_1);
      EXPECT_NEAR(nearly_0.P / reactant.P, 1, 10 * trace + 1e-11);
      EXPECT_NEAR(nearly_0.T / reactant.T, 1, 10 * trace + 1e-11);
      EXPECT_NEAR(nearly_1.P / product.P, 1, 10 * trace + 1e-11);
      EXPECT_NEAR(nearly_1.sound_speed_squared / product.sound_speed_squared, 1, 10 * trace + 1e-11);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 6);
}

TEST(Mixture, OfIdealGasesIsExact) {
  IdealGas const light(2, 3, 1), heavy(5, 7, 1); // masses and degrees of freedom, k_B = 1
  Mixture const mixture(light, heavy);
  int cases = 0;
  for (double const lambda : {1e-6, 0.3, 0.9}) {
    double const R = (1 - lambda) / 2 + lambda / 5, c_v = (1 - lambda) * 1.5 / 2 + lambda * 3.5 / 5;
    double const rho = 0.7, T = 3;
    auto const s = mixture.state(lambda, rho, c_v * T);
    EXPECT_NEAR(s.T / T, 1, 1e-13);
    EXPECT_NEAR(s.P / (rho * R * T), 1, 1e-13);
    EXPECT_NEAR(s.c_v / c_v, 1, 1e-13);
    EXPECT_NEAR(s.sound_speed_squared / ((1 + R / c_v) * R * T), 1, 1e-12);
    EXPECT_NEAR(mixture.energy_from_temperature(lambda, rho, T) / (c_v * T), 1, 1e-8);
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

/// Derivatives of the entropy by differences of fourth order, relative errors against 1/T and -P/(rho^2 T),
/// and of T and P against c_v and c^2.
struct Identities {
  double temperature = 0, pressure = 0, heat_capacity = 0, sound_speed = 0;
};

Identities identities(Mixture<Hz, Jwl> const& mixture, Trial const& t) {
  auto const centre = mixture.state(t.lambda, t.rho, t.e);
  auto const at = [&](double d_rho, double d_e) {
    return mixture.state(t.lambda, t.rho + d_rho, t.e + d_e, centre.split);
  };
  auto const slope = [](auto&& f, double h) {
    return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
  };
  double const h_e = 3e-4 * centre.c_v * centre.T, h_rho = 3e-4 * t.rho, P = centre.P, T = centre.T;
  double const s_e = slope([&](double h) { return at(0, h).s; }, h_e);
  double const s_rho = slope([&](double h) { return at(h, 0).s; }, h_rho);
  double const T_e = slope([&](double h) { return at(0, h).T; }, h_e);
  double const P_e = slope([&](double h) { return at(0, h).P; }, h_e);
  double const P_rho = slope([&](double h) { return at(h, 0).P; }, h_rho);
  double const c_2 = P_rho + P / (t.rho * t.rho) * P_e;
  return {.temperature = std::abs(s_e * T - 1),
          .pressure = std::abs(s_rho * t.rho * t.rho * T / P + 1),
          .heat_capacity = std::abs(T_e * centre.c_v - 1),
          .sound_speed = std::abs(c_2 / centre.sound_speed_squared - 1)};
}

TEST(Mixture, MaxwellsIdentitiesHoldForAdditiveVolumes) {
  std::mt19937_64 generator(5);
  auto const uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  Identities additive, paper;
  auto const keep = [](Identities& worst, Identities const& found) {
    worst = {std::max(worst.temperature, found.temperature), std::max(worst.pressure, found.pressure),
             std::max(worst.heat_capacity, found.heat_capacity),
             std::max(worst.sound_speed, found.sound_speed)};
  };
  int cases = 0;
  for (; cases < 200; ++cases) {
    auto const mixture = explosive(), printed = explosive(VolumeLaw::paper);
    double const lambda = uniform(0.01, 0.99), rho = uniform(1400, 1900), T = uniform(800, 4000);
    keep(additive, identities(mixture, {lambda, rho, mixture.energy_from_temperature(lambda, rho, T)}));
    keep(paper, identities(printed, {lambda, rho, printed.energy_from_temperature(lambda, rho, T)}));
  }
  std::printf(
      "%d states; additive: T %.1e, P %.1e, c_v %.1e, c^2 %.1e; paper: T %.1e, P %.1e, c_v %.1e, c^2 %.1e\n",
      cases, additive.temperature, additive.pressure, additive.heat_capacity, additive.sound_speed,
      paper.temperature, paper.pressure, paper.heat_capacity, paper.sound_speed);
  EXPECT_EQ(cases, 200);
  EXPECT_LT(std::max({additive.temperature, additive.pressure, additive.heat_capacity, additive.sound_speed}),
            1e-9);
  // The paper's law has its own T, P, c_v and c, but no entropy that they derive from.
  EXPECT_LT(std::max(paper.heat_capacity, paper.sound_speed), 1e-9);
  EXPECT_GT(std::max(paper.temperature, paper.pressure), 1e-3);
}

TEST(Mixture, AWarmStartGivesTheSameStateFaster) {
  auto const mixture = explosive();
  std::mt19937_64 generator(6);
  std::normal_distribution<double> normal;
  double const lambda = 0.3, rho = 1400, e = 3e6;
  auto split = mixture.state(lambda, rho, e).split;
  constexpr int calls = 20000;
  std::vector<Trial> trials;
  for (int i = 0; i < calls; ++i)
    trials.push_back(
        {lambda + 1e-4 * normal(generator), rho + normal(generator), e + 1e4 * normal(generator)});
  double sum = 0, best = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 5; ++repeat) {
    auto const start = std::clock();
    for (auto const& t : trials) {
      auto const s = mixture.state(t.lambda, t.rho, t.e, split);
      split = s.split;
      sum += s.P;
    }
    best = std::min(best, 1e9 * double(std::clock() - start) / CLOCKS_PER_SEC / calls);
  }
  std::printf("%.0f ns a warm call (steps of 0.1 %% in rho, 0.3 %% in e; mean P %.3e)\n", best,
              sum / 5 / calls);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    auto const& t = trials[i];
    auto const warm = mixture.state(t.lambda, t.rho, t.e, split), cold = mixture.state(t.lambda, t.rho, t.e);
    EXPECT_NEAR(warm.P / cold.P, 1, 1e-11);
    EXPECT_NEAR(warm.T / cold.T, 1, 1e-11);
    ++compared;
  }
  EXPECT_EQ(compared, 100);
  // A bad guess costs time, not the answer.
  for (auto const& bad : {MixtureSplit{1, 0}, MixtureSplit{-5, 0}, MixtureSplit{1e5, 30},
                          MixtureSplit{double(NAN), double(NAN)}})
    EXPECT_NEAR(mixture.state(lambda, rho, e, bad).P / mixture.state(lambda, rho, e).P, 1, 1e-11);
}

TEST(Mixture, NeedsNoModelsOfPacks) {
  Mixture const mixture(LjKolafaNezbeda(), IdealGas(1, 3, 1), VolumeLaw::additive_volume);
  for (double const lambda : {0.0, 0.2, 1.0})
    EXPECT_NEAR(mixture.state(lambda, 0.4, mixture.energy_from_temperature(lambda, 0.4, 2)).T, 2, 1e-9);
}

TEST(Mixture, RefusesByNameWhatHasNoEquilibrium) {
  auto const mixture = explosive();
  struct Case {
    Trial trial;
    std::string why;
  };
  std::vector<Case> const cases{
      {{-0.1, 1400, 3e6}, "lambda = -0.1 must lie in [0, 1]"},
      {{1.0001, 1400, 3e6}, "must lie in [0, 1]"},
      {{double(NAN), 1400, 3e6}, "must lie in [0, 1]"},
      {{0.5, -1, 3e6}, "density -1 must be > 0"},
      {{0.5, 1400, double(INFINITY)}, "must be > 0"},
      {{0.5, 1400, -5e6}, "coldest"},
      {{0.99, 743, 3e6}, "balance"},       // hot products of low pressure beside HZ
      {{1 - 0.9e-6, 743, 3e6}, "balance"}, // nor beside a trace of it
      {{0.5, 1e4, 3e6}, "balance"},
  };
  int refused = 0;
  for (auto const& [t, why] : cases)
    try {
      mixture.state(t.lambda, t.rho, t.e);
      ADD_FAILURE() << why;
    } catch (PhysicsError const& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
      ++refused;
    }
  EXPECT_EQ(refused, 9);
}

} // namespace
} // namespace mesobridge::fitting::test
