#include "cg/histogram.hpp"
#include "cg/kolmogorov_smirnov.hpp"
#include "md/error.hpp"
#include <cmath>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::cg::test {
namespace {

std::vector<double> gamma_samples(std::size_t n, double shape, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::gamma_distribution<double> gamma(shape, 1.0);
  std::vector<double> x(n);
  for (double& value : x)
    value = gamma(generator);
  return x;
}

TEST(KolmogorovSmirnov, PublishedQuantiles) {
  // Kolmogorov's distribution: the 5 % point is 1.3581, the 1 % point 1.6276. A sample that lies at one end
  // of the unit interval by a known distance has just that D.
  int cases = 0;
  for (auto [lambda, p] : {std::pair{1.3581, 0.05}, std::pair{1.6276, 0.01}, std::pair{1.2238, 0.10}}) {
    double const n = 10000, root = 100;
    double const distance = lambda / (root + 0.12 + 0.11 / root);
    std::vector<double> x;
    for (int i = 0; i < n; ++i)
      x.push_back((i + 1) / n * (1 - distance)); // all squeezed: F_n - F grows to `distance` at the last
    EXPECT_NEAR(kolmogorov_smirnov_distance(x, [](double u) { return u; }), distance, 1e-12);
    EXPECT_NEAR(kolmogorov_smirnov_p(x, [](double u) { return u; }), p, 5e-5);
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

TEST(KolmogorovSmirnov, PValuesOfTheTrueLawAreUniformAndAWrongLawFails) {
  auto const law = [](double x) { return gsl_cdf_gamma_P(x, 13.5, 1.0); };
  std::vector<double> p_values;
  for (std::uint64_t seed = 1; seed <= 500; ++seed)
    p_values.push_back(kolmogorov_smirnov_p(gamma_samples(200, 13.5, seed), law));
  EXPECT_GT(kolmogorov_smirnov_p(p_values, [](double u) { return u; }), 0.001);
  auto const wrong = [](double x) { return gsl_cdf_gamma_P(x, 13.0, 1.0); };
  EXPECT_LT(kolmogorov_smirnov_p(gamma_samples(2000, 13.5, 77), wrong), 1e-4);
}

TEST(KolmogorovSmirnov, RefusesBadInput) {
  auto const law = [](double u) { return u; };
  EXPECT_THROW(kolmogorov_smirnov_p(std::vector<double>(7, 0.5), law), InputError);
  EXPECT_THROW(kolmogorov_smirnov_p(std::vector<double>(20, 1.5), law), InputError);
  EXPECT_THROW(kolmogorov_smirnov_p(std::vector<double>(20, std::nan("")), law), InputError);
}

TEST(Histogram, FollowsTheDensityWithinItsErrors) {
  auto const x = gamma_samples(100000, 4.0, 5);
  auto const h = histogram(x, 0.0, 12.0, 24);
  double chi2 = 0, chi2_wrong = 0;
  for (std::size_t bin = 0; bin < 24; ++bin) {
    double const a = double(bin) * h.width(), b = a + h.width();
    auto const exact = [&](double shape) {
      return (gsl_cdf_gamma_P(b, shape, 1.0) - gsl_cdf_gamma_P(a, shape, 1.0)) / h.width();
    };
    chi2 += std::pow((h.density[bin] - exact(4.0)) / h.se[bin], 2);
    chi2_wrong += std::pow((h.density[bin] - exact(4.05)) / h.se[bin], 2);
  }
  EXPECT_LT(chi2, 52); // 0.1 % point for 24 degrees of freedom
  EXPECT_GT(chi2_wrong, 52);
  double total = double(h.below + h.above) / 1e5;
  for (double density : h.density)
    total += density * h.width();
  EXPECT_NEAR(total, 1.0, 1e-12);
}

TEST(Histogram, PutsEdgesWhereTheyBelong) {
  std::vector<double> const x{-0.1, 0.0, 0.5, std::nextafter(1.0, 0.0), 1.0, 2.0};
  auto const h = histogram(x, 0.0, 1.0, 2, 4.0);
  EXPECT_EQ(h.below, 1u);
  EXPECT_EQ(h.above, 2u);
  EXPECT_EQ(h.counts, (std::vector<std::size_t>{1, 2}));
  EXPECT_NEAR(h.se[0] / histogram(x, 0.0, 1.0, 2, 1.0).se[0], 2.0, 1e-12);
  EXPECT_THROW(histogram(x, 1.0, 1.0, 2), InputError);
  EXPECT_THROW(histogram(x, 0.0, 1.0, 0), InputError);
  EXPECT_THROW(histogram({}, 0.0, 1.0, 2), InputError);
}

} // namespace
} // namespace mesobridge::cg::test
