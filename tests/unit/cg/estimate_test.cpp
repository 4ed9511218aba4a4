#include "cg/estimate.hpp"
#include "cg/jackknife.hpp"
#include "md/error.hpp"
#include "unit/cg/ar1.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <rapidcheck/gtest.h>

namespace mesobridge::cg::test {
namespace {

double mean_of(std::vector<double> const& v) {
  return std::accumulate(v.begin(), v.end(), 0.0) / double(v.size());
}

double sample_variance(std::span<double const> v) {
  double const mean = std::accumulate(v.begin(), v.end(), 0.0) / double(v.size());
  double sum = 0;
  for (double x : v)
    sum += (x - mean) * (x - mean);
  return sum / double(v.size() - 1);
}

TEST(Estimate, AutocovarianceEqualsTheDirectSum) {
  std::mt19937_64 generator(1);
  auto const x = ar1(101, 0.5, 3.0, generator); // a length that is no power of two
  auto const gamma = autocovariance(x, 40);
  double const mean = mean_of(x);
  int cases = 0;
  for (std::size_t lag = 0; lag <= 40; ++lag, ++cases) {
    double sum = 0;
    for (std::size_t i = 0; i + lag < x.size(); ++i)
      sum += (x[i] - mean) * (x[i + lag] - mean);
    EXPECT_NEAR(gamma[lag], sum / double(x.size() - lag), 1e-13);
  }
  EXPECT_EQ(cases, 41);
}

TEST(Estimate, AutocorrelationTimeOfAr1) {
  std::mt19937_64 generator(2);
  int cases = 0;
  for (double phi : {0.0, 0.5, 0.9, 0.98}) {
    auto const memory = autocorrelation_time(ar1(200000, phi, 1.0, generator));
    EXPECT_NEAR(memory.tau, ar1_tau(phi), 5 * memory.tau_se) << phi;
    EXPECT_LT(memory.tau_se, 0.1 * memory.tau);
    EXPECT_GT(std::abs(memory.tau - 1.5 * ar1_tau(phi)), 4 * memory.tau_se) << "a wrong time must be seen";
    EXPECT_NEAR(memory.variance, 1.0, 0.1);
    ++cases;
  }
  EXPECT_EQ(cases, 4);
}

/// How often the true mean lies within one and two standard errors, over many series.
template <class Estimator>
std::pair<double, double> coverage(Estimator const& estimator, double phi, std::size_t n, int series) {
  std::mt19937_64 generator(3);
  int one = 0, two = 0;
  for (int k = 0; k < series; ++k) {
    auto const estimate = estimator(ar1(n, phi, 7.0, generator));
    one += agrees(estimate, 7.0, 1), two += agrees(estimate, 7.0, 2);
  }
  return {double(one) / series, double(two) / series};
}

TEST(Estimate, ErrorBarsCoverTheTruthAsOftenAsTheySay) {
  // Binomial standard errors of the fractions over 2000 series: 0.0104 and 0.0047. Series of 100 correlation
  // times have errors that are themselves uncertain by about 15 %, by which they are quoted larger (C51):
  // more of the means lie within one of them than of a known error, and as many within two.
  int cases = 0;
  for (double phi : {0.0, 0.8, 0.95}) {
    auto const n = std::size_t(200 * ar1_tau(phi));
    auto const [one, two] = coverage([](auto const& x) { return estimate_mean(x); }, phi, n, 2000);
    EXPECT_NEAR(one, 0.72, 0.055) << phi;
    EXPECT_NEAR(two, 0.954, 0.027) << phi;
    auto const [one_block, two_block] =
        coverage([](auto const& x) { return estimate_by_blocking(x); }, phi, n, 2000);
    EXPECT_NEAR(one_block, 0.683, 0.06) << phi; // blocking is the coarser method
    EXPECT_NEAR(two_block, 0.954, 0.04) << phi;
    ++cases;
  }
  EXPECT_EQ(cases, 3);
  auto const naive = [](std::vector<double> const& x) {
    return Estimate{mean_of(x), std::sqrt(sample_variance(x) / double(x.size())), double(x.size())};
  };
  EXPECT_LT(coverage(naive, 0.95, 3900, 500).first, 0.3)
      << "errors that ignore the memory must be seen to fail";
}

TEST(Estimate, BlockingAgreesWithAutocorrelation) {
  std::mt19937_64 generator(4);
  auto const x = ar1(1 << 16, 0.9, -2.0, generator);
  double const exact = std::sqrt(2 * ar1_tau(0.9) / double(x.size()));
  EXPECT_NEAR(estimate_by_autocorrelation(x).se, exact, 0.1 * exact);
  EXPECT_NEAR(estimate_by_blocking(x).se, exact, 0.15 * exact);
  EXPECT_NEAR(estimate_mean(x).n_eff, double(x.size()) / (2 * ar1_tau(0.9)), 0.2 * double(x.size()) / 19);
}

TEST(Estimate, BlockingCatchesASlowModeThatTheWindowCuts) {
  std::mt19937_64 generator(5);
  auto x = ar1(1 << 16, 0.0, 0.0, generator);
  auto const slow = ar1(x.size(), 0.999, 0.0, generator);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += 0.05 * slow[i];
  double const exact = std::sqrt((1 + 0.0025 * 2 * ar1_tau(0.999)) / double(x.size()));
  EXPECT_LT(estimate_by_autocorrelation(x).se, 0.5 * exact);
  EXPECT_GT(estimate_mean(x).se, 0.65 * exact);
  EXPECT_LT(estimate_mean(x).se, 1.3 * exact);
}

// Short runs of a fluid: sound and noise over a slow exchange of energy of small amplitude. The root mean
// square of the quoted errors is to be the spread of the means; by the automatic window alone it was 1.8
// times too small.
TEST(Estimate, ErrorsAreTheSpreadWhereNoiseHidesASlowMode) {
  std::mt19937_64 generator(8);
  int cases = 0;
  for (std::size_t const n : {900u, 3000u}) {
    double spread = 0, quoted = 0, by_window = 0;
    for (int k = 0; k < 600; ++k) {
      auto x = ar1(n, 0.0, 0.0, generator);
      auto const slow = ar1(n, std::exp(-1.0 / 30), 0.0, generator);
      for (std::size_t i = 0; i < n; ++i)
        x[i] += 0.3 * slow[i];
      spread += std::pow(mean_of(x), 2), quoted += std::pow(estimate_mean(x).se, 2);
      by_window += std::pow(estimate_by_autocorrelation(x).se, 2);
    }
    EXPECT_NEAR(std::sqrt(spread / quoted), 1.0, 0.1) << n; // of 600: 0.03 by chance
    EXPECT_GT(std::sqrt(spread / by_window), 1.5) << n;
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

// Few independent samples tell little of their own error. In units of errors that know nothing of this,
// deviations squared are 1.7 in the mean for these series.
TEST(Estimate, DeviationsOfShortSeriesAreOneStandardErrorInTheMean) {
  std::mt19937_64 generator(10);
  int cases = 0;
  for (auto const& [n, tau] : {std::pair(80u, 5.0), {400u, 20.0}}) {
    double squares = 0, by_window = 0, n_eff = 0;
    constexpr int runs = 2000;
    for (int k = 0; k < runs; ++k) {
      auto const x = ar1(n, std::exp(-1 / tau), 0.0, generator);
      auto const estimate = estimate_mean(x);
      squares += std::pow(deviation(estimate, 0), 2) / runs, n_eff += estimate.n_eff / runs;
      by_window += std::pow(deviation(estimate_by_autocorrelation(x), 0), 2) / runs;
    }
    EXPECT_NEAR(squares, 1.15, 0.2) << n; // by chance 0.05
    EXPECT_GT(by_window, 1.5) << n;
    EXPECT_NEAR(n_eff, double(n) / (2 * tau), 0.2 * double(n) / (2 * tau)) << n;
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

// A run that is shorter than its memory has one independent sample, not less, and an error above the spread
// of what it has seen.
TEST(Estimate, ShortSeriesHaveOneIndependentSampleAtLeast) {
  std::mt19937_64 generator(11);
  int runs = 0, wider = 0;
  for (int k = 0; k < 400; ++k, ++runs) {
    auto const x = ar1(16, std::exp(-1 / 200.0), 0.0, generator);
    EXPECT_GE(estimate_by_autocorrelation(x).n_eff, 1);
    auto const estimate = estimate_mean(x);
    EXPECT_GE(estimate.n_eff, 1);
    wider += estimate.se * estimate.se > sample_variance(x);
  }
  EXPECT_EQ(runs, 400);
  EXPECT_GT(wider, 0);
}

TEST(Estimate, VarianceOfAr1AndItsError) {
  std::mt19937_64 generator(6);
  int within_two = 0, cases = 0;
  double mean = 0;
  for (int k = 0; k < 500; ++k, ++cases) {
    auto const estimate = estimate_variance(ar1(2000, 0.8, 4.0, generator));
    within_two += agrees(estimate, 1.0, 2);
    mean += estimate.mean / 500;
  }
  EXPECT_EQ(cases, 500);
  EXPECT_NEAR(double(within_two) / 500, 0.95, 0.035);
  // The squares have rho(t) = phi^(2t): one estimate has se = sqrt(2 (1 + phi^2)/(1 - phi^2)/n) = 0.067,
  // their mean 0.003.
  EXPECT_NEAR(mean, 1.0, 0.01);
}

TEST(Estimate, AShortSeriesDoesNotMakeTheVarianceSmall) {
  // The mean of 100 samples with tau = 4.5 takes 9 % off the squared deviations; 2000 series show 1 %.
  std::mt19937_64 generator(9);
  double mean = 0, naive = 0;
  for (int k = 0; k < 2000; ++k) {
    auto const x = ar1(100, 0.8, 4.0, generator);
    mean += estimate_variance(x).mean / 2000, naive += sample_variance(x) / 2000;
  }
  EXPECT_NEAR(mean, 1.0, 0.035);
  EXPECT_LT(naive, 0.95);
}

TEST(Estimate, JackknifeOfTheVarianceAgreesWithLinearPropagation) {
  std::mt19937_64 generator(7);
  auto const x = ar1(40000, 0.8, 4.0, generator);
  std::vector<Sums> blocks;
  for (std::size_t first = 0; first < x.size(); first += 400) {
    Sums sums(3, 0.0);
    for (double const one : std::span(x).subspan(first, 400))
      sums[0] += 1, sums[1] += one, sums[2] += one * one;
    blocks.push_back(sums);
  }
  auto const variance = [](Sums const& s) {
    return std::vector<double>{(s[2] - s[1] * s[1] / s[0]) / (s[0] - 1)};
  };
  auto const by_jackknife = jackknife(blocks, variance)[0];
  auto const linear = estimate_variance(x);
  EXPECT_NEAR(by_jackknife.mean, linear.mean, 0.2 * linear.se);
  EXPECT_NEAR(by_jackknife.se, linear.se, 0.3 * linear.se);
  EXPECT_TRUE(agrees(by_jackknife, 1.0, 4));
  EXPECT_FALSE(agrees(by_jackknife, 1.2, 4));
}

TEST(Estimate, CovarianceOfMeansOfTwoSeriesWithKnownCorrelation) {
  std::mt19937_64 generator(8);
  auto const x = ar1(100000, 0.9, 0.0, generator), noise = ar1(100000, 0.5, 0.0, generator);
  std::vector<double> y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    y[i] = 100 * (0.6 * x[i] + 0.8 * noise[i]); // cov(x, y) = 60 var(x), at every lag that of x
  double const exact = 60 * 2 * ar1_tau(0.9) / double(x.size());
  EXPECT_NEAR(covariance_of_means(x, y), exact, 0.15 * exact);
  double const se_product = estimate_mean(x).se * estimate_mean(noise).se;
  EXPECT_LT(std::abs(covariance_of_means(x, noise)), 0.3 * se_product);
}

TEST(Estimate, AConstantHasNoErrorAndAlternationNoNegativeOne) {
  std::vector<double> const constant(100, 0.1);
  EXPECT_NEAR(estimate_mean(constant).mean, 0.1, 1e-15);
  EXPECT_LT(estimate_mean(constant).se, 1e-15);
  EXPECT_EQ(estimate_variance(constant).mean, 0);
  std::vector<double> alternating(100);
  for (std::size_t i = 0; i < 100; ++i)
    alternating[i] = i % 2 ? 1 : -1;
  EXPECT_GT(estimate_mean(alternating).se, 0);
}

TEST(Estimate, RefusesTooFewAndNonFiniteSamples) {
  std::vector<double> x(100, 1.0);
  EXPECT_THROW(estimate_mean(std::span(x).first(15)), InputError);
  EXPECT_THROW(autocorrelation_time(std::span(x).first(3)), InputError);
  EXPECT_THROW(autocovariance(x, 100), InputError);
  EXPECT_THROW(jackknife(std::vector<Sums>(3, Sums{1}), [](Sums const& s) { return s; }), InputError);
  x[50] = std::nan("");
  EXPECT_THROW(estimate_mean(x), InputError);
}

RC_GTEST_PROP(Estimate, ScalesAndShiftsWithItsSeries, ()) {
  auto const seed = *rc::gen::inRange(1, 1000000);
  auto const scale = *rc::gen::inRange(1, 1000) * 0.01;
  auto const shift = *rc::gen::inRange(-1000, 1000) * 0.01;
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  auto const x = ar1(500, 0.7, 0.0, generator);
  std::vector<double> y(x.size());
  std::transform(x.begin(), x.end(), y.begin(), [&](double v) { return shift + scale * v; });
  auto const a = estimate_mean(x), b = estimate_mean(y);
  RC_ASSERT(std::abs(b.mean - (shift + scale * a.mean)) < 1e-10);
  RC_ASSERT(std::abs(b.se - scale * a.se) < 1e-8 * scale);
}

} // namespace
} // namespace mesobridge::cg::test
