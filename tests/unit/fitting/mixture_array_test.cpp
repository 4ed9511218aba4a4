#include "fitting/eos/mixture_array.hpp"
#include "unit/fitting/built_in.hpp"
#include <chrono>
#include <ctime>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <regex>

namespace mesobridge::fitting::test {
namespace {

/// Arrays of states, owned.
struct Batch {
  std::vector<double> lambda, rho, e, s, T, r, P, C, c_2;

  void push(double progress, double density, double energy) {
    lambda.push_back(progress), rho.push_back(density), e.push_back(energy);
    T.push_back(1000), r.push_back(0);
    for (auto* const other : {&s, &P, &C, &c_2})
      other->push_back(0);
  }
  MixtureStates states() { return {lambda, rho, e, s, T, r, P, C, c_2}; }
  std::size_t size() const { return lambda.size(); }
};

struct Range {
  double low, high;
};

/// Traces of either part, pure parts and all between, over densities and energies of all kinds.
Batch random_batch(Range rho, Range e, int n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  auto const uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  Batch batch;
  for (int i = 0; i < n; ++i) {
    double const trace = std::pow(10, uniform(-15, 0)), kind = uniform(0, 4);
    double const thin = std::pow(10, uniform(0, std::log10(rho.high)));
    batch.push(kind < 1   ? trace
               : kind < 2 ? 1 - trace
                          : uniform(0, 1),
               uniform(0, 1) < 0.5 ? uniform(rho.low, rho.high) : thin, uniform(e.low, e.high));
  }
  return batch;
}

struct Outcome {
  int answered = 0, refused = 0;
  double worst = 0;
};

/// Every state is answered, and then obeys the equations of equilibrium, or refused by a name that says why.
template <class A, class B>
Outcome check_all(MixtureArray<A, B> const& array, Batch batch, char const* title) {
  std::map<std::size_t, std::string> refusals;
  int refused_again = 0;
  auto const start = std::clock();
  array.from_energy(batch.states(), 0, batch.size(), [&](std::size_t i, PhysicsError const& error) {
    refused_again += refusals.contains(i);
    refusals[i] = error.what();
  });
  double const microseconds = 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC / double(batch.size());
  Outcome found;
  static std::regex const numbers("-?[0-9][0-9.e+-]*");
  std::map<std::string, int> reasons;
  for (auto const& [place, why] : refusals)
    ++reasons[std::regex_replace(why.substr(why.find(": ") + 2), numbers, "#").substr(0, 50)];
  auto const& mixture = array.mixture();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (refusals.contains(i)) {
      ++found.refused;
      continue;
    }
    ++found.answered;
    double const lambda = batch.lambda[i], rho = batch.rho[i], T = batch.T[i];
    EXPECT_TRUE(T > 0 && batch.C[i] > 0 && std::isfinite(batch.s[i] + batch.c_2[i])) << lambda << " " << rho;
    if (component(lambda) != Component::mixed)
      continue;
    auto const d = mixture_densities(mixture.law(), lambda, rho, batch.r[i]);
    auto const part_0 = mixture.reactant().isochore(d.reactant),
               part_1 = mixture.product().isochore(d.product);
    double const e_0 = part_0.energy(T), e_1 = part_1.energy(T);
    // In thin matter pressures are small differences of large terms, whose last digits are their scale.
    double const scale = d.reactant * part_0.pressure_density_slope(T) +
                         d.product * part_1.pressure_density_slope(T) +
                         T * (part_0.pressure_slope(T) + part_1.pressure_slope(T));
    found.worst =
        std::max({found.worst,
                  std::abs((1 - lambda) * e_0 + lambda * e_1 - batch.e[i]) / (std::abs(e_0) + std::abs(e_1)),
                  std::abs(part_0.pressure(T) - batch.P[i]) / scale,
                  std::abs(part_1.pressure(T) - batch.P[i]) / scale});
  }
  std::printf("%s: %zu states, %d answered (largest violation %.1e), %d refused; %.1f us each\n", title,
              batch.size(), found.answered, found.worst, found.refused, microseconds);
  for (auto const& [why, count] : reasons)
    std::printf("  %d: %s...\n", count, why.c_str());
  EXPECT_EQ(refused_again, 0);
  EXPECT_LT(found.worst, 1e-10);
  EXPECT_LE(reasons.size(), 5u); // nothing but the reasons that the models know
  return found;
}

StiffenedGas const& water() {
  return built_in<StiffenedGas>("water");
}
IdealGas gas() {
  return IdealGas(30 * atomic_mass, 6);
}

void check_both_pairs_and_laws(int n) {
  int runs = 0;
  for (auto const law : {VolumeLaw::additive_volume, VolumeLaw::paper}) {
    bool const additive = law == VolumeLaw::additive_volume;
    auto const explosive = check_all(MixtureArray(Mixture(nitromethane(), products(), law)),
                                     random_batch({800, 2200}, {-2e6, 1e7}, n, 21),
                                     additive ? "HZ, JWL, additive volumes" : "HZ, JWL, paper's law");
    auto const gases = check_all(
        MixtureArray(Mixture(water(), gas(), law)), random_batch({20, 1400}, {-1.5e6, 5e6}, n, 22),
        additive ? "stiffened and ideal gas, additive volumes" : "stiffened and ideal gas, paper's law");
    EXPECT_GT(explosive.answered, n / 3);
    EXPECT_GT(gases.answered, n / 3);
    ++runs;
  }
  EXPECT_EQ(runs, 2);
}

TEST(MixtureArray, AnswersOrRefusesEveryState) {
  check_both_pairs_and_laws(1000);
}

TEST(Long_MixtureArray, AnswersOrRefusesAMillionStates) {
  check_both_pairs_and_laws(1000000);
}

/// States along which SDPD goes: dense, hot, with any progress.
template <class A, class B>
Batch warm_batch(Mixture<A, B> const& mixture, int n) {
  std::mt19937_64 generator(8);
  auto const uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  Batch batch;
  for (int i = 0; i < n; ++i) {
    double const lambda = i % 5 == 0 ? 0 : i % 5 == 1 ? 1 : uniform(1e-3, 0.999);
    double const rho = uniform(1400, 1900);
    batch.push(lambda, rho, mixture.energy_from_temperature(lambda, rho, uniform(1500, 4500)));
  }
  return batch;
}

TEST(MixtureArray, IsEachMixtureAlone) {
  int cases = 0;
  for (auto const law : {VolumeLaw::additive_volume, VolumeLaw::paper}) {
    Mixture const mixture(nitromethane(), products(), law);
    MixtureArray const array(mixture);
    for (int const n : {1, 7, 8, 9, 203}) {
      auto batch = warm_batch(mixture, n);
      auto const none = [](std::size_t, PhysicsError const& error) { ADD_FAILURE() << error.what(); };
      array.from_energy(batch.states(), 0, batch.size(), none);
      // Back by the entropy, from a start that is off.
      auto back = batch;
      std::ranges::fill(back.e, 0);
      for (auto& T : back.T)
        T *= 1.01;
      array.from_entropy(back.states(), 0, back.size(), none);
      for (std::size_t i = 0; i < batch.size(); ++i, ++cases) {
        auto const alone = mixture.state(batch.lambda[i], batch.rho[i], batch.e[i]);
        EXPECT_NEAR(batch.T[i] / alone.T, 1, 1e-11);
        EXPECT_NEAR(batch.P[i] / alone.P, 1, 1e-11);
        EXPECT_NEAR(batch.s[i] / alone.s, 1, 1e-12);
        EXPECT_NEAR(batch.C[i] / alone.c_v, 1, 1e-11);
        EXPECT_NEAR(batch.c_2[i] / alone.sound_speed_squared, 1, 1e-10);
        EXPECT_NEAR(back.e[i] / batch.e[i], 1, 1e-11);
        EXPECT_NEAR(back.P[i] / batch.P[i], 1, 1e-11);
        auto const by_entropy = mixture.state_from_entropy(batch.lambda[i], batch.rho[i], batch.s[i]);
        EXPECT_NEAR(by_entropy.e / batch.e[i], 1, 1e-11);
      }
    }
  }
  EXPECT_EQ(cases, 2 * (1 + 7 + 8 + 9 + 203));
}

TEST(MixtureArray, TheNumbersOfAParticleDoNotDependOnItsNeighbours) {
  Mixture const mixture(nitromethane(), products());
  MixtureArray const array(mixture);
  auto const none = [](std::size_t, PhysicsError const& error) { ADD_FAILURE() << error.what(); };
  auto together = warm_batch(mixture, 203);
  auto apart = together;
  array.from_energy(together.states(), 0, 203, none);
  for (std::size_t first = 0; first < 203; first += 29)
    array.from_energy(apart.states(), first, first + 29, none);
  EXPECT_EQ(together.T, apart.T);
  EXPECT_EQ(together.P, apart.P);
  EXPECT_EQ(together.r, apart.r);
  EXPECT_EQ(together.c_2, apart.c_2);
}

TEST(MixtureArray, ARestartFindsTheSameBits) {
  int compared = 0;
  auto const check = [&](auto const& mixture, Batch batch) {
    MixtureArray const array(mixture);
    std::vector<std::size_t> refused;
    array.from_energy(batch.states(), 0, batch.size(),
                      [&](std::size_t i, PhysicsError const&) { refused.push_back(i); });
    auto again = batch;
    for (auto* const lost : {&again.P, &again.C, &again.c_2})
      std::ranges::fill(*lost, 0);
    // Other neighbours in memory, too.
    for (std::size_t first = 0; first < batch.size(); first += 5)
      array.response(again.states(), first, std::min(first + 5, batch.size()), [](auto, auto const&) {});
    for (std::size_t i = 0; i < batch.size(); ++i)
      if (std::ranges::find(refused, i) == refused.end()) {
        EXPECT_EQ(again.P[i], batch.P[i]) << i;
        EXPECT_EQ(again.C[i], batch.C[i]) << i;
        EXPECT_EQ(again.c_2[i], batch.c_2[i]) << i;
        ++compared;
      }
  };
  check(Mixture(nitromethane(), products()), random_batch({800, 2200}, {-2e6, 1e7}, 300, 31));
  check(Mixture(LjKolafaNezbeda(), IdealGas(1, 3, 1)), random_batch({0.1, 0.8}, {2, 6}, 20, 32));
  EXPECT_GT(compared, 150);
}

TEST(MixtureArray, BeginsFromTemperatures) {
  Mixture const mixture(nitromethane(), products());
  auto const wanted = warm_batch(mixture, 41);
  auto batch = wanted;
  std::mt19937_64 generator(3);
  for (auto& T : batch.T)
    T = std::uniform_real_distribution<double>(1500, 4500)(generator);
  auto const none = [](std::size_t, PhysicsError const& error) { ADD_FAILURE() << error.what(); };
  MixtureArray(mixture).from_temperature(batch.states(), 0, batch.size(), none);
  auto solved = batch;
  std::ranges::fill(solved.T, 1000);
  MixtureArray(mixture).from_energy(solved.states(), 0, batch.size(), none);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    EXPECT_NEAR(solved.T[i] / batch.T[i], 1, 1e-11);
    EXPECT_NEAR(solved.P[i] / batch.P[i], 1, 1e-11);
    EXPECT_NEAR(solved.s[i] / batch.s[i], 1, 1e-12);
  }
}

TEST(MixtureArray, TakesTracesForPureComponents) {
  EXPECT_EQ(component(0.99e-4), Component::reactant);
  EXPECT_EQ(component(1.01e-4), Component::mixed);
  EXPECT_EQ(component(1 - 1.1e-6), Component::mixed);
  EXPECT_EQ(component(1 - 0.9e-6), Component::product);
  for (double const outside : {-1e-9, 1 + 1e-9, double(NAN)})
    EXPECT_EQ(component(outside), Component::mixed);
  // Hot products of low pressure cannot balance a trace of HZ: the rule answers where the mixture cannot.
  Mixture const mixture(nitromethane(), products());
  double const burnt = 1 - 0.9e-6, rho = 743, e = 3e6;
  EXPECT_THROW(mixture.state(burnt, rho, e), PhysicsError);
  Batch batch;
  batch.push(burnt, rho, e);
  batch.push(-1e-9, rho, e);
  std::vector<std::size_t> refused;
  MixtureArray(mixture).from_energy(batch.states(), 0, 2, [&](std::size_t i, PhysicsError const& error) {
    refused.push_back(i);
    EXPECT_NE(std::string(error.what()).find("must lie in [0, 1]"), std::string::npos) << error.what();
  });
  EXPECT_EQ(refused, std::vector<std::size_t>{1});
  EXPECT_NEAR(batch.P[0] / products().pressure(e, rho), 1, 1e-12);
  EXPECT_NEAR(batch.T[0] / products().temperature(e, rho), 1, 1e-12);
}

TEST(MixtureArray, ModelsWithoutPacksGoOneByOne) {
  LjKolafaNezbeda const dense;
  IdealGas const thin(1, 3, 1);
  Mixture const mixture(dense, thin, VolumeLaw::additive_volume);
  Batch batch;
  for (double const lambda : {0.0, 0.2, 1.0})
    batch.push(lambda, 0.4, mixture.energy_from_temperature(lambda, 0.4, 2));
  MixtureArray(mixture).from_energy(
      batch.states(), 0, 3, [](std::size_t, PhysicsError const& error) { ADD_FAILURE() << error.what(); });
  for (double const T : batch.T)
    EXPECT_NEAR(T, 2, 1e-9);
}

/// Of an independent solver (Newton's method on the entropy's maximum), additive volumes.
struct Known {
  double lambda, rho, e, T, P, s, rho_0, rho_1, C, c;
};

TEST(MixtureArray, GivesTheStatesOfAnIndependentSolver) {
  Mixture const mixture(nitromethane(), products());
  MixtureArray const array(mixture);
  int cases = 0;
  for (auto const& k : {Known{.lambda = 0.3,
                       .rho = 1700,
                       .e = 3e6,
                       .T = 3001.025732,
                       .P = 11.9003922e9,
                       .s = 12144.182523,
                       .rho_0 = 1780.59373,
                       .rho_1 = 1537.60995,
                       .C = 1677.060,
                       .c = 5639.812},
                        Known{.lambda = 0.9,
                        .rho = 1500,
                        .e = 6e6,
                        .T = 4732.394922,
                        .P = 12.8834850e9,
                        .s = 16709.545694,
                        .rho_0 = 1747.99391,
                        .rho_1 = 1476.72138,
                        .C = 2609.000,
                        .c = 4649.717}}) {
    Batch batch;
    batch.push(k.lambda, k.rho, k.e);
    array.from_energy(batch.states(), 0, 1, [](std::size_t, PhysicsError const&) { FAIL(); });
    auto const d = mixture_densities(mixture.law(), k.lambda, k.rho, batch.r[0]);
    EXPECT_NEAR(batch.T[0], k.T, 1e-6);
    EXPECT_NEAR(batch.P[0], k.P, 60);
    EXPECT_NEAR(batch.s[0], k.s, 2e-3);
    EXPECT_NEAR(d.reactant, k.rho_0, 1e-5);
    EXPECT_NEAR(d.product, k.rho_1, 1e-5);
    EXPECT_NEAR(batch.C[0], k.C, 1e-3);
    EXPECT_NEAR(std::sqrt(batch.c_2[0]), k.c, 1e-3);
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

} // namespace
} // namespace mesobridge::fitting::test
