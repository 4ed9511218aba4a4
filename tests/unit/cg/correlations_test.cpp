#include "cg/correlations.hpp"
#include "cg/jackknife.hpp"
#include "md/error.hpp"
#include "unit/cg/ar1.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::cg::test {
namespace {

constexpr std::size_t molecules = 60, frames = 600;
constexpr double edge = 12, mass = 19, beta = 0.95, U_mean = 40, U_spread = 6, interval = 0.1, phi = 0.8;

/// Blobs for which the key approximation holds exactly: momenta and energies that forget exponentially,
/// centres anywhere. `coupling` adds so much of each one's local density to its energy, in units of their
/// spreads.
BlobSeries made(std::uint64_t seed, double coupling = 0) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> anywhere(0, edge);
  BlobSeries series{.molecules = molecules, .atoms = 19, .mass = mass};
  series.R.resize(frames * molecules), series.P.resize(frames * molecules);
  series.U.resize(frames * molecules), series.U_kin.assign(frames * molecules, 25);
  double const spread = std::sqrt(mass / beta);
  for (std::size_t m = 0; m < molecules; ++m) {
    auto const U = ar1(frames, phi, 0, generator), x = ar1(frames, phi, 0, generator),
               y = ar1(frames, phi, 0, generator), z = ar1(frames, phi, 0, generator);
    for (std::size_t t = 0; t < frames; ++t) {
      series.U[t * molecules + m] = U_mean + U_spread * U[t];
      series.P[t * molecules + m] = spread * Vec3{x[t], y[t], z[t]};
    }
  }
  for (std::size_t t = 0; t < frames; ++t) {
    series.times.push_back(interval * double(t));
    series.boxes.push_back({{edge, edge, edge}});
    Vec3 mean; // the total momentum of a melt is zero
    for (std::size_t k = t * molecules; k < (t + 1) * molecules; ++k)
      mean += series.P[k] / double(molecules);
    for (std::size_t k = t * molecules; k < (t + 1) * molecules; ++k) {
      series.P[k] -= mean;
      series.R[k] = {anywhere(generator), anywhere(generator), anywhere(generator)};
    }
    for (std::size_t a = t * molecules; a < (t + 1) * molecules && coupling != 0; ++a)
      for (std::size_t b = t * molecules; b < (t + 1) * molecules; ++b)
        if (a != b)
          series.U[a] += coupling * U_spread *
                         (norm(series.boxes[t].minimum_image(series.R[a] - series.R[b])) < 2 ? 1 : 0);
  }
  return series;
}

constexpr CorrelationSettings settings{.h = 5, .bin_width = 0.5, .density_bins = 6, .map_bins = 6};

TEST(Correlations, IndependentBlobsPassEveryTestWithTheRightNumbers) {
  auto const found = correlations(made(1), settings);
  double const tau = interval * ar1_tau(phi);
  EXPECT_NEAR(found.tau_U.tau, tau, 5 * found.tau_U.se);
  EXPECT_NEAR(found.tau_P.tau, tau, 5 * found.tau_P.se);
  EXPECT_NEAR(found.tau_rho.tau, interval / 2, 0.01) << "every frame has new positions";
  EXPECT_GT(found.block_time, 6 * found.tau_U.tau);
  EXPECT_TRUE(agrees(found.beta, beta, 4)) << found.beta.mean << " +- " << found.beta.se;
  EXPECT_FALSE(agrees(found.beta, 1.05 * beta, 4));
  EXPECT_TRUE(agrees(found.U_mean, U_mean, 4));
  EXPECT_TRUE(agrees(found.U_variance, U_spread * U_spread, 4));
  EXPECT_TRUE(agrees(found.K_mean, 1.5 / beta * (1 - 1.0 / molecules), 4));
  EXPECT_TRUE(agrees(found.C_KU, 0, 4));
  EXPECT_TRUE(agrees(found.C_UD, 0, 4));
  EXPECT_LT(found.C_KU.se, 0.02);
  ASSERT_EQ(found.tests.size(), 11u);
  for (auto const& test : found.tests)
    EXPECT_LT(std::abs(test.in_se), 4) << test.name << ": " << test.statement;
  ASSERT_GE(found.g.x.size(), 8u);
  int bins = 0;
  for (std::size_t k = 0; k < found.g.x.size(); ++k, ++bins) {
    EXPECT_TRUE(agrees(found.g.y[k], 1, 5)) << "g at " << found.g.x[k] << ": " << found.g.y[k].mean;
    EXPECT_TRUE(agrees(found.u.y[k], 1, 5));
    EXPECT_TRUE(agrees(found.u_minus_g.y[k], 0, 5));
    EXPECT_LT(found.u_minus_g.y[k].se, found.g.y[k].se) << "what g and u share cancels";
  }
  EXPECT_GE(bins, 8);
  double sum = 0;
  for (auto const& density : found.P_U.y)
    sum += density.mean * (found.P_U.x[1] - found.P_U.x[0]);
  EXPECT_NEAR(sum, 1, 0.01);
}

TEST(Correlations, ADependenceOfEnergyOnPlaceIsFound) {
  auto const found = correlations(made(2, 0.3), settings);
  EXPECT_GT(found.C_UD.mean, 10 * found.C_UD.se);
  EXPECT_GT(found.test("C_UD = 0").in_se, 10);
  EXPECT_GT(found.pair_energy.y.front().mean, 1 + 5 * found.pair_energy.y.front().se)
      << "near pairs have more";
  EXPECT_GT(found.U_of_density.y.back().mean, 5 * found.U_of_density.y.back().se);
  EXPECT_LT(std::abs(found.test("C_KU = 0").in_se), 4) << "momenta stay independent";
}

TEST(Correlations, ConfigurationalEnergiesTellTheSameWithLessNoise) {
  auto series = made(4, 0.3);
  std::mt19937_64 generator(5);
  std::normal_distribution<double> noise(0, 2 * U_spread);
  for (std::size_t k = 0; k < series.U.size(); ++k) { // most of the energy's spread is kinetic
    double const kinetic = noise(generator);
    series.U_kin[k] += kinetic, series.U[k] += kinetic;
  }
  auto const found = correlations(series, settings);
  auto const &W = found.configurational.contact_energy, &C = found.configurational.C_UD;
  // A pair in contact has one neighbour more than the others, and common neighbours: counted by the volumes
  // of a ball of radius 2 and of the part that two balls at the mean distance share.
  double const ball = 4 * M_PI / 3 * 8 / (edge * edge * edge), unit = 0.3 * U_spread, others = molecules - 2;
  double const mean = U_mean + unit * (molecules - 1) * ball, near = mean + unit * (1 - ball);
  double const r = 0.75 * found.contact, common = ball * (1 - 0.75 * r / 2 + std::pow(r / 2, 3) / 16);
  double const expected = (near * near + unit * unit * others * (common - ball * ball)) / (mean * mean);
  EXPECT_NEAR(W.mean, expected, 4 * W.se);
  EXPECT_NEAR(found.contact_energy.mean, expected, 4 * found.contact_energy.se);
  EXPECT_GT(std::abs(W.mean - 1), 5 * W.se) << "a wrong answer would be seen";
  EXPECT_LT(W.se, 0.7 * found.contact_energy.se);
  EXPECT_LT(C.se, 0.7 * found.C_UD.se);
  EXPECT_LT(std::abs(C.mean - found.C_UD.mean), 4 * found.C_UD.se);
  EXPECT_GT(C.mean, 10 * C.se);
}

TEST(Correlations, TheDensitysRangeMayExceedThatOfTheRadialDistribution) {
  auto series = made(6);
  constexpr double wider = 2.5;
  for (auto& R : series.R)
    R = wider * R;
  for (auto& box : series.boxes)
    box.edge = wider * box.edge;
  auto wide = settings;
  wide.h = 14;
  auto const found = correlations(series, wide);
  EXPECT_LT(found.g.x.back(), 12);
  double const uniform = mass * (molecules - 1) / std::pow(wider * edge, 3);
  EXPECT_TRUE(agrees(found.density_mean, uniform, 4)) << found.density_mean.mean << " for " << uniform;
  EXPECT_FALSE(agrees(found.density_mean, 1.05 * uniform, 4));
}

TEST(Correlations, ARunThatIsTooShortIsRefusedWithTheLengthThatItNeeds) {
  auto series = made(3);
  series.times.resize(40), series.boxes.resize(40);
  series.R.resize(40 * molecules), series.P.resize(40 * molecules), series.U.resize(40 * molecules);
  try {
    correlations(series, settings);
    FAIL() << "accepted";
  } catch (PhysicsError const& error) {
    EXPECT_NE(std::string(error.what()).find("at least"), std::string::npos) << error.what();
  }
  auto wide = settings;
  wide.h = 7;
  EXPECT_THROW(correlations(made(3), wide), InputError) << "more than half the box";
}

TEST(Correlations, LucysKernelHasVolumeOne) {
  double sum = 0;
  for (double r = 0.0005; r < 3; r += 0.001)
    sum += 4 * M_PI * r * r * lucy(r, 2.5) * 0.001;
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_EQ(lucy(2.5, 2.5), 0);
}

TEST(Jackknife, ErrorsOfCorrelatedSeriesCoverTheTruth) {
  // Means and ratios of series that forget within (1 + phi)/(1 - phi)/2 = 4.5 samples, in blocks of 100.
  std::mt19937_64 generator(11);
  int inside_1 = 0, inside_2 = 0, runs = 0;
  for (; runs < 200; ++runs) {
    auto const a = ar1(2000, phi, 3, generator), b = ar1(2000, phi, 2, generator);
    std::vector<Sums> blocks(20, Sums(2, 0.0));
    for (std::size_t k = 0; k < 2000; ++k)
      blocks[k / 100][0] += a[k], blocks[k / 100][1] += b[k];
    auto const ratio = jackknife(blocks, [](Sums const& s) { return std::vector<double>{s[0] / s[1]}; })[0];
    inside_1 += agrees(ratio, 1.5, 1), inside_2 += agrees(ratio, 1.5, 2);
  }
  EXPECT_NEAR(inside_1, 0.67 * runs, 3.5 * std::sqrt(0.67 * 0.33 * runs));
  EXPECT_NEAR(inside_2, 0.94 * runs, 3.5 * std::sqrt(0.94 * 0.06 * runs));
}

} // namespace
} // namespace mesobridge::cg::test
