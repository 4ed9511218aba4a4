#include "cg/entropy.hpp"
#include "md/error.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::cg::test {
namespace {

/// A harmonic molecule of N atoms with fixed momentum has n = 3N - 3 quadratic momenta and as many quadratic
/// positions: S = (n - 1) ln U exactly, so T = U/(n - 1) and C = n - 1. At temperature T its energy is
/// Gamma(n, T) and its kinetic part a fraction Beta(n/2, n/2) of it.
EnergySamples harmonic(int atoms, double T, int blocks, int per_block, std::mt19937_64& generator) {
  double const n = 3 * atoms - 3;
  std::gamma_distribution<double> half(n / 2, T);
  EnergySamples samples{.beta = 1 / T, .U = {}, .U_kin = {}, .beta_without = {}};
  for (int block = 0; block < blocks; ++block) {
    samples.U.emplace_back(), samples.U_kin.emplace_back();
    for (int i = 0; i < per_block; ++i) {
      double const kinetic = half(generator), potential = half(generator);
      samples.U.back().push_back(kinetic + potential);
      samples.U_kin.back().push_back(kinetic);
    }
  }
  return samples;
}

constexpr int atoms = 19;
constexpr double n_1 = 3 * atoms - 4; // n - 1

std::vector<EnergySamples> several(std::uint64_t seed, int per_block = 1000) {
  std::mt19937_64 generator(seed);
  std::vector<EnergySamples> samples;
  // Unequally many, so that each set's weight counts.
  samples.push_back(harmonic(atoms, 0.8, 20, per_block, generator));
  samples.push_back(harmonic(atoms, 1.0, 20, per_block / 3, generator));
  samples.push_back(harmonic(atoms, 1.25, 20, 2 * per_block, generator));
  return samples;
}

TEST(Entropy, EveryRouteFindsTheExactOneOfAHarmonicMolecule) {
  auto const samples = several(1);
  int cases = 0;
  for (auto route : {EntropyRoute::density, EntropyRoute::kinetic})
    for (std::size_t order : {1u, 2u, 3u}) {
      auto const fit = fit_entropy(samples, route, atoms, {.order = order});
      for (double U : {42.0, 53.0, 66.0}) {
        auto const T = fit.estimate([&](EntropyCurve const& c) { return c.T(U); });
        auto const C = fit.estimate([&](EntropyCurve const& c) { return c.C(U); });
        auto const S = fit.estimate([&](EntropyCurve const& c) { return c.S(U) - c.S(50); });
        EXPECT_TRUE(agrees(T, U / n_1, 4)) << T.mean << " +- " << T.se << " at " << U;
        EXPECT_TRUE(agrees(C, n_1, 4)) << C.mean << " +- " << C.se << " at " << U << ", order " << order;
        EXPECT_TRUE(agrees(S, n_1 * std::log(U / 50), 4)) << S.mean << " +- " << S.se;
        EXPECT_FALSE(agrees(T, 1.05 * U / n_1, 4)) << "an error of 5 % is seen";
        EXPECT_GT(T.se, 0);
        ++cases;
      }
    }
  EXPECT_EQ(cases, 18);
}

/// The energies of bonds that repel (FENE) begin far above 0, those of attractive molecules below it.
TEST(Entropy, IsThatOfTheMoleculeWhereverItsEnergiesBegin) {
  int cases = 0;
  for (double const least : {300.0, -80.0, -54.0})
    for (auto route : {EntropyRoute::density, EntropyRoute::kinetic}) {
      auto samples = several(1);
      for (auto& set : samples)
        for (auto& block : set.U)
          for (double& U : block)
            U += least;
      auto const fit = fit_entropy(samples, route, atoms, {.order = 2});
      for (double U : {42.0, 53.0, 66.0}) {
        auto const T = fit.estimate([&](EntropyCurve const& c) { return c.T(least + U); });
        auto const C = fit.estimate([&](EntropyCurve const& c) { return c.C(least + U); });
        EXPECT_TRUE(agrees(T, U / n_1, 4)) << T.mean << " +- " << T.se << " at " << U;
        EXPECT_TRUE(agrees(C, n_1, 4)) << C.mean << " +- " << C.se << " at " << U << " above " << least;
        ++cases;
      }
    }
  EXPECT_EQ(cases, 18);
}

TEST(Entropy, TheMeltsSingleTemperatureDoesToo) {
  std::mt19937_64 generator(2);
  std::vector<EnergySamples> const samples{harmonic(atoms, 1.0, 25, 2000, generator)};
  auto const fit = fit_entropy(samples, EntropyRoute::density, atoms, {.order = 3});
  auto const C = fit.estimate([](EntropyCurve const& c) { return c.C(54); });
  EXPECT_TRUE(agrees(C, n_1, 4)) << C.mean << " +- " << C.se;
  EXPECT_LT(C.se, 0.02 * n_1);
}

TEST(Entropy, EquipartitionIsLowByThePredictedPart) {
  auto const samples = several(3);
  Equipartition const equipartition(samples, atoms);
  // <E_kin>^U = U/2, so the thesis's T is U/(3N) instead of U/(3N - 4).
  auto const T = equipartition.T(53);
  EXPECT_TRUE(agrees(T, 53.0 / (3 * atoms), 4)) << T.mean << " +- " << T.se;
  EXPECT_FALSE(agrees(T, 53.0 / n_1, 10)) << "the bias of 7 % stands far out of the errors";
  EXPECT_TRUE(agrees(equipartition.C(53), 3 * atoms, 4));
  EXPECT_TRUE(agrees(equipartition.slope_C(), 3 * atoms, 4));
  auto const bins = kinetic_temperature(samples, atoms, 10);
  ASSERT_GE(bins.U.size(), 6u);
  for (std::size_t b = 0; b < bins.U.size(); ++b) {
    EXPECT_TRUE(agrees(bins.T_equipartition[b], bins.U[b] / (3 * atoms), 5)) << b;
    // Within a bin 1/T bends: a small part of T.
    EXPECT_NEAR(bins.T_exact[b].mean, bins.U[b] / n_1, 5 * bins.T_exact[b].se + 0.005) << b;
  }
}

TEST(Entropy, WhamAgreesWithTheExactCurveBinByBin) {
  auto const samples = several(4);
  auto const found = wham(samples, 40);
  ASSERT_GE(found.U.size(), 25u);
  int beyond_4 = 0;
  for (std::size_t b = 0; b < found.U.size(); ++b) {
    double const exact = n_1 * std::log(found.U[b] / found.U_reference);
    beyond_4 += std::abs(found.S[b].mean - exact) > 4 * found.S[b].se + 0.05;
    EXPECT_NEAR(found.S[b].mean, exact, 1) << found.U[b];
  }
  EXPECT_EQ(beyond_4, 0);
}

TEST(Entropy, ErrorsCoverTheTruthAsOftenAsTheySay) {
  int inside_1 = 0, inside_2 = 0, runs = 0;
  for (std::uint64_t seed = 100; seed < 160; ++seed, ++runs) {
    auto const samples = several(seed, 100);
    auto const fit = fit_entropy(samples, EntropyRoute::density, atoms, {.order = 2});
    auto const C = fit.estimate([](EntropyCurve const& c) { return c.C(53); });
    inside_1 += agrees(C, n_1, 1), inside_2 += agrees(C, n_1, 2);
  }
  ASSERT_EQ(runs, 60);
  EXPECT_NEAR(inside_1, 0.68 * runs, 3 * std::sqrt(0.68 * 0.32 * runs));
  EXPECT_GE(inside_2, 0.95 * runs - 3 * std::sqrt(0.95 * 0.05 * runs));
}

TEST(EntropyCurve, DerivativesAgreeAndTheEndsGoOnSmoothly) {
  EntropyCurve const curve({.U_ref = 50, .width = 0.2, .order = 3}, {10.0, -0.3, 0.05}, 35, 70);
  int cases = 0;
  for (double U : {20.0, 34.9, 36.0, 50.0, 69.0, 71.0, 200.0}) {
    double const h = 1e-4;
    EXPECT_NEAR((curve.S(U + h) - curve.S(U - h)) / (2 * h), curve.inverse_T(U), 1e-7) << U;
    EXPECT_NEAR(2 * h / (curve.T(U + h) - curve.T(U - h)), curve.C(U), 1e-3) << U;
    EXPECT_GT(curve.C(U), 0) << U;
    ++cases;
  }
  EXPECT_EQ(cases, 7);
  for (double border : {35.0, 70.0}) {
    EXPECT_NEAR(curve.S(border - 1e-9), curve.S(border + 1e-9), 1e-6);
    EXPECT_NEAR(curve.T(border - 1e-9), curve.T(border + 1e-9), 1e-6);
  }
  EXPECT_GT(curve.U_zero(), 0);
  EXPECT_THROW(curve.T(curve.U_zero() - 0.1), PhysicsError);
}

TEST(Entropy, RefusesTooLittleAndSaysWhy) {
  std::mt19937_64 generator(5);
  std::vector<EnergySamples> const few{harmonic(atoms, 1.0, 3, 100, generator)};
  EXPECT_THROW(fit_entropy(few, EntropyRoute::density, atoms, {}), InputError);
  EXPECT_THROW(fit_entropy(several(6, 10), EntropyRoute::density, atoms, {.order = 9}), InputError);
}

} // namespace
} // namespace mesobridge::cg::test
