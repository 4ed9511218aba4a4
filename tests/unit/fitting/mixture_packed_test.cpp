#include "fitting/eos/mixture_packed.hpp"
#include "unit/fitting/built_in.hpp"
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <regex>

namespace mesobridge::fitting::test {
namespace {

struct Trial {
  double lambda, rho, e;
};
struct Range {
  double low, high;
};

double uniform(std::mt19937_64& generator, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

/// Traces of either part and all between, over densities and energies of all kinds.
std::vector<Trial> random_trials(Range rho, Range e, int n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<Trial> trials;
  for (int i = 0; i < n; ++i) {
    double const trace = std::pow(10, uniform(generator, -15, 0)), kind = uniform(generator, 0, 4);
    double const thin = std::pow(10, uniform(generator, 0, std::log10(rho.high)));
    trials.push_back({.lambda = kind < 1   ? trace
                                : kind < 2 ? 1 - trace
                                           : uniform(generator, 0, 1),
                      .rho = uniform(generator, 0, 1) < 0.5 ? uniform(generator, rho.low, rho.high) : thin,
                      .e = uniform(generator, e.low, e.high)});
  }
  return trials;
}

/// States along which SDPD goes: dense, hot, with any progress.
template <class A, class B>
std::vector<Trial> warm_trials(Mixture<A, B> const& mixture, int n) {
  std::mt19937_64 generator(8);
  std::vector<Trial> trials;
  for (int i = 0; i < n; ++i) {
    double const lambda = uniform(generator, 1e-3, 0.999), rho = uniform(generator, 1400, 1900);
    trials.push_back(
        {lambda, rho, mixture.energy_from_temperature(lambda, rho, uniform(generator, 1500, 4500))});
  }
  return trials;
}

/// One member of the trials from a place on, as many as fill a pack; the last one fills the lanes left over.
Pack load(std::vector<Trial> const& trials, std::size_t first, double Trial::*member) {
  Pack some;
  for (int lane = 0; lane < Pack::size; ++lane)
    some.v[lane] = trials[std::min(first + static_cast<std::size_t>(lane), trials.size() - 1)].*member;
  return some;
}

/// What a solution says of one state, by the pack or, where that does not solve it, by Mixture.
struct Answer {
  double T, r, P, s, C, c_2;
  bool by_pack;
};

/// Calls answered(i, answer) or refused(i, why) once for every trial.
template <class A, class B>
void solve_all(Mixture<A, B> const& mixture, std::vector<Trial> const& trials, PackedSplit const& guess,
               auto&& answered, auto&& refused) {
  PackedMixture const packed(mixture);
  for (std::size_t first = 0; first < trials.size(); first += Pack::size) {
    Pack const lambda = load(trials, first, &Trial::lambda), rho = load(trials, first, &Trial::rho),
               e = load(trials, first, &Trial::e);
    auto const found = packed.from_energy(lambda, rho, e, guess);
    auto const here = packed.at(lambda, rho, found.split);
    Pack const P = here.pressure(), s = found.other, C = here.heat_capacity(),
               c_2 = here.sound_speed_squared();
    auto const fine =
        found.solved & packed.covered(here) & between(C, 0, std::numeric_limits<double>::infinity());
    for (int lane = 0; lane < Pack::size && first + static_cast<std::size_t>(lane) < trials.size(); ++lane) {
      auto const i = first + static_cast<std::size_t>(lane);
      if (fine[lane]) {
        answered(i, Answer{found.split.T.v[lane], found.split.log_density_ratio.v[lane], P.v[lane], s.v[lane],
                           C.v[lane], c_2.v[lane], true});
        continue;
      }
      try {
        auto const m = mixture.state(trials[i].lambda, trials[i].rho, trials[i].e);
        answered(i, Answer{m.T, m.split.log_density_ratio, m.P, m.s, m.c_v, m.sound_speed_squared, false});
      } catch (PhysicsError const& error) {
        refused(i, error.what());
      }
    }
  }
}

/// How far an answer is from the equations of equilibrium, by the pure models: energies, pressures.
template <class A, class B>
double violation(Mixture<A, B> const& mixture, Trial const& t, Answer const& a) {
  auto const d = mixture_densities(mixture.law(), t.lambda, t.rho, a.r);
  auto const part_0 = mixture.reactant().isochore(d.reactant), part_1 = mixture.product().isochore(d.product);
  double const e_0 = part_0.energy(a.T), e_1 = part_1.energy(a.T);
  // In thin matter pressures are small differences of large terms, whose last digits are their scale.
  double const scale = d.reactant * part_0.pressure_density_slope(a.T) +
                       d.product * part_1.pressure_density_slope(a.T) +
                       a.T * (part_0.pressure_slope(a.T) + part_1.pressure_slope(a.T));
  return std::max({std::abs((1 - t.lambda) * e_0 + t.lambda * e_1 - t.e) / (std::abs(e_0) + std::abs(e_1)),
                   std::abs(part_0.pressure(a.T) - a.P) / scale,
                   std::abs(part_1.pressure(a.T) - a.P) / scale});
}

/// Every state is answered, and then obeys the equations of equilibrium, or refused by a name that says why.
template <class A, class B>
void check_all(Mixture<A, B> const& mixture, std::vector<Trial> const& trials, char const* title) {
  std::size_t answers = 0, by_packs = 0, refusals = 0;
  double worst = 0;
  std::map<std::string, int> reasons;
  static std::regex const numbers("-?[0-9][0-9.e+-]*");
  solve_all(
      mixture, trials, {1000, 0},
      [&](std::size_t i, Answer const& a) {
        ++answers, by_packs += a.by_pack;
        EXPECT_TRUE(a.T > 0 && a.C > 0 && std::isfinite(a.s + a.c_2))
            << trials[i].lambda << " " << trials[i].rho;
        worst = std::max(worst, violation(mixture, trials[i], a));
      },
      [&](std::size_t, std::string const& why) {
        ++refusals;
        ++reasons[std::regex_replace(why.substr(why.find(": ") + 2), numbers, "#").substr(0, 50)];
      });
  std::printf("%s: %zu states, %zu answered (%zu by packs, largest violation %.1e), %zu refused\n", title,
              trials.size(), answers, by_packs, worst, refusals);
  for (auto const& [why, count] : reasons)
    std::printf("  %d: %s...\n", count, why.c_str());
  EXPECT_EQ(answers + refusals, trials.size());
  EXPECT_GT(answers, trials.size() / 3);
  EXPECT_GT(by_packs, trials.size() / 20);
  EXPECT_LT(worst, 1e-10);
  EXPECT_LE(reasons.size(), 5u); // nothing but the reasons that the models know
}

void check_both_pairs_and_laws(int n) {
  int runs = 0;
  for (auto const law : {VolumeLaw::additive_volume, VolumeLaw::paper}) {
    bool const additive = law == VolumeLaw::additive_volume;
    check_all(Mixture(nitromethane(), products(), law), random_trials({800, 2200}, {-2e6, 1e7}, n, 21),
              additive ? "HZ, JWL, additive volumes" : "HZ, JWL, paper's law");
    check_all(Mixture(built_in<StiffenedGas>("water"), IdealGas(30 * atomic_mass, 6), law),
              random_trials({20, 1400}, {-1.5e6, 5e6}, n, 22),
              additive ? "stiffened and ideal gas, additive volumes"
                       : "stiffened and ideal gas, paper's law");
    ++runs;
  }
  EXPECT_EQ(runs, 2);
}

TEST(PackedMixture, AnswersOrRefusesEveryState) {
  check_both_pairs_and_laws(1000);
}

TEST(Long_PackedMixture, AnswersOrRefusesAMillionStates) {
  check_both_pairs_and_laws(1000000);
}

TEST(PackedMixture, IsEachMixtureAlone) {
  std::size_t cases = 0, by_packs = 0;
  for (auto const law : {VolumeLaw::additive_volume, VolumeLaw::paper}) {
    Mixture const mixture(nitromethane(), products(), law);
    PackedMixture const packed(mixture);
    auto const trials = warm_trials(mixture, 203);
    solve_all(
        mixture, trials, {2500, 0},
        [&](std::size_t i, Answer const& a) {
          ++cases, by_packs += a.by_pack;
          auto const& [lambda, rho, e] = trials[i];
          auto const alone = mixture.state(lambda, rho, e);
          EXPECT_NEAR(a.T / alone.T, 1, 1e-11);
          EXPECT_NEAR(a.P / alone.P, 1, 1e-11);
          EXPECT_NEAR(a.s / alone.s, 1, 1e-12);
          EXPECT_NEAR(a.C / alone.c_v, 1, 1e-11);
          EXPECT_NEAR(a.c_2 / alone.sound_speed_squared, 1, 1e-10);
          // Back by the entropy, from a start that is off.
          auto const back = packed.from_entropy(lambda, rho, a.s, {1.01 * a.T, a.r});
          ASSERT_TRUE(all_of(back.solved)) << i;
          auto const there = packed.at(lambda, rho, back.split);
          EXPECT_NEAR(there.energy().v[0] / e, 1, 1e-11);
          EXPECT_NEAR(back.other.v[0] / there.energy().v[0], 1, 1e-13);
          EXPECT_NEAR(there.pressure().v[0] / a.P, 1, 1e-11);
          EXPECT_NEAR(mixture.state_from_entropy(lambda, rho, a.s).e / e, 1, 1e-11);
        },
        [](std::size_t i, std::string const& why) { ADD_FAILURE() << i << " " << why; });
  }
  EXPECT_EQ(cases, 2U * 203);
  EXPECT_GE(by_packs, 400U); // the guess is far from a few
}

TEST(PackedMixture, ALaneDoesNotDependOnTheOthers) {
  Mixture const mixture(nitromethane(), products());
  auto trials = warm_trials(mixture, 203);
  trials[5].e = -1e9, trials[17].lambda = 2, trials[31].rho = double(NAN); // neighbours that are not solved
  std::vector<Answer> answers;
  PackedSplit const guess{2500, 0};
  int refused = 0;
  solve_all(
      mixture, trials, guess, [&](std::size_t, Answer const& a) { answers.push_back(a); },
      [&](std::size_t i, std::string const&) {
        refused += i == 5 || i == 17 || i == 31;
        answers.push_back({});
      });
  EXPECT_EQ(refused, 3);
  PackedMixture const packed(mixture);
  int compared = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    auto const& [lambda, rho, e] = trials[i];
    auto const alone = packed.from_energy(lambda, rho, e, guess); // the same state in all lanes
    if (!answers[i].by_pack)
      continue;
    EXPECT_EQ(alone.split.T.v[0], answers[i].T) << i;
    EXPECT_EQ(alone.split.log_density_ratio.v[0], answers[i].r) << i;
    EXPECT_EQ(packed.at(lambda, rho, alone.split).sound_speed_squared().v[0], answers[i].c_2) << i;
    ++compared;
  }
  EXPECT_GE(compared, 195); // the guess is far from a few
}

/// Of an independent solver (Newton's method on the entropy's maximum), additive volumes.
struct Known {
  double lambda, rho, e, T, P, s, rho_0, rho_1, C, c;
};

TEST(PackedMixture, GivesTheStatesOfAnIndependentSolver) {
  Mixture const mixture(nitromethane(), products());
  std::vector<Known> const known{
      {0.3, 1700, 3e6, 3001.025732, 11.9003922e9, 12144.182523, 1780.59373, 1537.60995, 1677.060, 5639.812},
      {0.9, 1500, 6e6, 4732.394922, 12.8834850e9, 16709.545694, 1747.99391, 1476.72138, 2609.000, 4649.717}};
  std::vector<Trial> trials;
  for (auto const& k : known)
    trials.push_back({k.lambda, k.rho, k.e});
  int cases = 0;
  solve_all(
      mixture, trials, {3000, 0},
      [&](std::size_t i, Answer const& a) {
        auto const& k = known[i];
        auto const d = mixture_densities(mixture.law(), k.lambda, k.rho, a.r);
        EXPECT_TRUE(a.by_pack);
        EXPECT_NEAR(a.T, k.T, 1e-6);
        EXPECT_NEAR(a.P, k.P, 60);
        EXPECT_NEAR(a.s, k.s, 2e-3);
        EXPECT_NEAR(d.reactant, k.rho_0, 1e-5);
        EXPECT_NEAR(d.product, k.rho_1, 1e-5);
        EXPECT_NEAR(a.C, k.C, 1e-3);
        EXPECT_NEAR(std::sqrt(a.c_2), k.c, 1e-3);
        ++cases;
      },
      [](std::size_t i, std::string const& why) { ADD_FAILURE() << i << " " << why; });
  EXPECT_EQ(cases, 2);
}

} // namespace
} // namespace mesobridge::fitting::test
