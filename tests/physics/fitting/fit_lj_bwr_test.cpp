#include "fitting/eos/evaluate.hpp"
#include "unit/fitting/synthetic_grid.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

double square(double x) {
  return x * x;
}

/// Fits to many independent campaigns on fluids that differ from the published one by 0.5 %, as the prior
/// says.
struct Ensemble {
  static constexpr int replicas = 150;
  double chi_2 = 0, degrees = 0; // sums
  double held_fraction = 0;      // mean
  double z_2 = 0;                // mean squared error of P and U between the nodes, in predicted errors
  int predictions = 0;           // of which:
  int within_1 = 0, within_3 = 0;
  double held_z_2 = 0;       // mean squared held-out deviation
  double worst_relative = 0; // error of P and U (of max(|U|, T)) in the sampled box
  int unstable = 0, strengthened = 0;
};

Ensemble run_ensemble(LjBwrFitOptions const& options, Campaign const& campaign, double width) {
  std::mt19937_64 generator(21);
  Ensemble sum;
  for (int replica = 0; replica < Ensemble::replicas; ++replica) {
    LjBwr const truth = different_fluid(width, generator);
    auto const fit = fit_lj_bwr(measured_grid(truth, campaign, generator), options);
    sum.chi_2 += fit.chi_2;
    sum.degrees += fit.degrees_of_freedom;
    sum.held_fraction += fit.held_out_fraction / Ensemble::replicas;
    sum.held_z_2 += square(fit.rms_held_out_deviation) / Ensemble::replicas;
    sum.unstable += !fit.stability.stable();
    sum.strengthened += fit.strengthened;
    for (double rho : {0.6, 0.77, 0.95})
      for (double T : {3.7, 6.2, 10.1}) {
        auto const isochore = truth.isochore(rho);
        auto const fitted = fit.predict(rho, T);
        double const U = isochore.energy(T), P = isochore.pressure(T);
        for (double z : {(fitted.U - U) / fitted.U_se, (fitted.P - P) / fitted.P_se}) {
          sum.z_2 += z * z;
          sum.within_1 += std::abs(z) < 1;
          sum.within_3 += std::abs(z) < 3;
          ++sum.predictions;
        }
        sum.worst_relative = std::max({sum.worst_relative, std::abs(fitted.P / P - 1),
                                       std::abs(fitted.U - U) / std::max(std::abs(U), T)});
      }
  }
  sum.z_2 /= sum.predictions;
  return sum;
}

TEST(FitLjBwr, RecoversFluidsThatDifferFromThePublishedOneWithHonestErrors) {
  auto const sum = run_ensemble({}, {}, 0.005);
  double const n = Ensemble::replicas, share_1 = sum.within_1 / double(sum.predictions);
  std::printf(
      "%d fits, %d predictions: chi^2/dof %.3f, held out within 3 se %.4f (rms %.3f), prediction z^2 %.3f, "
      "|z| < 1: %.3f, |z| < 3: %.4f, worst relative error %.4f, strengthened %d\n",
      Ensemble::replicas, sum.predictions, sum.chi_2 / sum.degrees, sum.held_fraction,
      std::sqrt(sum.held_z_2), sum.z_2, share_1, sum.within_3 / double(sum.predictions), sum.worst_relative,
      sum.strengthened);
  EXPECT_EQ(sum.predictions, 18 * Ensemble::replicas);
  // chi^2/dof has the standard error sqrt(2/dof) here; the prior's pull on chi^2 is part of the effective
  // parameters.
  EXPECT_NEAR(sum.chi_2 / sum.degrees, 1, 4 * std::sqrt(2 / sum.degrees));
  // The 18 predictions of a fit hang together: count every fit as about 3 independent ones.
  EXPECT_NEAR(sum.z_2, 1, 4 * std::sqrt(2 / (3 * n)));
  EXPECT_NEAR(share_1, 0.683, 4 * 0.466 / std::sqrt(3 * n));
  EXPECT_GT(sum.within_3 / double(sum.predictions), 0.985);
  EXPECT_GT(sum.held_fraction, 0.985);
  EXPECT_NEAR(sum.held_z_2, 1, 0.1);
  EXPECT_LT(sum.worst_relative, 0.005);
  EXPECT_EQ(sum.unstable, 0);
}

TEST(FitLjBwr, APriorThatIsTooSureIsSeenInItsErrors) {
  auto const sum = run_ensemble({.prior_width = 5e-4}, {}, 0.005);
  EXPECT_GT(sum.z_2, 3);
  EXPECT_GT(sum.chi_2 / sum.degrees, 1.1);
}

TEST(FitLjBwr, FindsNothingToCorrectInThePublishedFluid) {
  std::mt19937_64 generator(22);
  LjBwr const published(lj_bwr_1993);
  auto const fit = fit_lj_bwr(measured_grid(published, {}, generator));
  EXPECT_LT(fit.evidence_width, 1.5e-3);
  EXPECT_LT(fit.effective_parameters, 6);
  EXPECT_LT(fit.difference_from_published().P, 1e-3);
  EXPECT_LT(fit.difference_from_published().U, 1e-3);
  int cases = 0;
  for (auto const& point : fit.points) {
    EXPECT_NEAR(point.P_fit / point.P_published, 1, 1e-3);
    EXPECT_NEAR(point.U_fit, point.U_published, 1e-3 * point.T);
    ++cases;
  }
  EXPECT_EQ(cases, 30);
}

TEST(FitLjBwr, ThePriorMeansWhatItSays) {
  // Fluids drawn from a prior of 0.5 % differ from the published one by 0.5 % (rms over the region, U and P).
  std::mt19937_64 generator(34);
  LjBwr const published(lj_bwr_1993);
  double sum = 0;
  int terms = 0;
  for (int fluid = 0; fluid < 60; ++fluid) {
    auto const drawn = different_fluid(0.005, generator);
    for_each_state(wide_region(), 32, 24, [&](double rho, double T) {
      auto const a = drawn.isochore(rho), b = published.isochore(rho);
      double const U = b.energy(T), P = b.pressure(T);
      sum += square((a.energy(T) - U) / std::max(std::abs(U), T)) +
             square((a.pressure(T) - P) / std::max(std::abs(P), rho * T));
      terms += 2;
    });
  }
  EXPECT_EQ(terms, 60 * 2 * 32 * 24);
  // 60 fluids of 32 free combinations each; a tenfold or halved prior would be far off.
  EXPECT_NEAR(std::sqrt(sum / terms), 0.005, 0.0006);
}

TEST(FitLjBwr, TellsHowFarItIsFromThePublishedFluid) {
  std::mt19937_64 generator(32);
  auto const fit = fit_lj_bwr(measured_grid(different_fluid(0.005, generator), {}, generator));
  auto const largest = fit.difference_from_published();
  EXPECT_LT(largest.P, 0.01);
  EXPECT_LT(largest.U, 0.01);
  double nodes = 0;
  int corners = 0;
  for (auto const& point : fit.points) {
    bool const corner = (point.rho == fit.sampled.rho_min || point.rho == fit.sampled.rho_max) &&
                        (point.T == fit.sampled.T_min || point.T == fit.sampled.T_max);
    double const difference = std::abs(point.P_fit / point.P_published - 1);
    nodes = std::max(nodes, difference);
    if (corner) {
      EXPECT_LE(difference, largest.P * (1 + 1e-6));
      ++corners;
    }
  }
  EXPECT_EQ(corners, 4);
  EXPECT_NEAR(nodes, largest.P, 0.3 * largest.P);
}

TEST(FitLjBwr, StaysPhysicalFarOutsideTheData) {
  std::mt19937_64 generator(23);
  LjBwr const published(lj_bwr_1993), truth = different_fluid(0.01, generator);
  auto const fit = fit_lj_bwr(measured_grid(truth, {}, generator));
  EXPECT_TRUE(fit.stability.stable());
  EXPECT_EQ(fit.checked.rho_max, 1.3);
  EXPECT_EQ(fit.checked.T_max, 100);
  int cases = 0;
  for (double rho : {0.05, 0.3, 1.2})
    for (double T : {1.4, 5.0, 50.0}) {
      EXPECT_NEAR(fit.eos.isochore(rho).pressure(T), published.isochore(rho).pressure(T),
                  0.06 * std::max(rho * T, published.isochore(rho).pressure(T)));
      ++cases;
    }
  EXPECT_EQ(cases, 9);
}

TEST(FitLjBwr, LeavingAStateOutEqualsARefit) {
  std::mt19937_64 generator(24);
  auto const truth = different_fluid(0.005, generator);
  auto const grid = measured_grid(truth, {}, generator);
  LjBwrFitOptions const options{.prior_width = 0.004};
  auto const fit = fit_lj_bwr(grid, options);
  int cases = 0;
  for (std::size_t left_out : {0u, 13u, 29u}) {
    auto without = grid;
    without.points.erase(without.points.begin() + static_cast<std::ptrdiff_t>(left_out));
    auto const& point = fit.points[left_out];
    auto const predicted = fit_lj_bwr(without, options).predict(point.rho, point.T);
    EXPECT_NEAR(point.P_held_out, predicted.P, 1e-8);
    EXPECT_NEAR(point.U_held_out, predicted.U, 1e-8);
    EXPECT_NEAR(point.P_held_out_se, std::hypot(predicted.P_se, point.P_se), 1e-8);
    EXPECT_NEAR(point.U_held_out_se, std::hypot(predicted.U_se, point.U_se), 1e-8);
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

TEST(FitLjBwr, LeavingAFoldOutEqualsARefit) {
  std::mt19937_64 generator(25);
  auto const grid = measured_grid(different_fluid(0.005, generator), {}, generator);
  auto const fit = fit_lj_bwr(grid, {.prior_width = 0.004, .folds = 5});
  cg::StateGrid without;
  for (std::size_t i = 0; i < grid.points.size(); ++i)
    if (i % 5 != 2)
      without.points.push_back(grid.points[i]);
  auto const refit = fit_lj_bwr(without, {.prior_width = 0.004});
  int cases = 0;
  for (std::size_t i = 2; i < grid.points.size(); i += 5, ++cases)
    EXPECT_NEAR(fit.points[i].P_held_out, refit.predict(grid.points[i].rho, grid.points[i].T).P, 1e-8);
  EXPECT_EQ(cases, 6);
}

TEST(FitLjBwr, CovarianceGivesTheErrorsOfTheFit) {
  std::mt19937_64 generator(26);
  auto const fit = fit_lj_bwr(measured_grid(different_fluid(0.005, generator), {}, generator));
  int cases = 0;
  for (auto const& point : fit.points) {
    auto const predicted = fit.predict(point.rho, point.T);
    EXPECT_NEAR(predicted.P, point.P_fit, 1e-8 * point.P_fit);
    EXPECT_NEAR(predicted.P_se / point.P_fit_se, 1, 1e-6);
    EXPECT_NEAR(predicted.U_se / point.U_fit_se, 1, 1e-6);
    ++cases;
  }
  EXPECT_EQ(cases, 30);
}

TEST(FitLjBwr, DataThatContradictThermodynamicsDoNotFit) {
  // A pressure that is 3 % rho* too large with the energies unchanged has no free energy.
  std::mt19937_64 generator(27);
  auto grid = measured_grid(LjBwr(lj_bwr_1993), {.relative_noise = 0.0005}, generator);
  for (auto& point : grid.points)
    point.P.mean *= 1 + 0.03 * point.rho;
  auto const fit = fit_lj_bwr(grid);
  EXPECT_GT(fit.chi_2 / fit.degrees_of_freedom, 1.8);
  EXPECT_GT(fit.rms_held_out_deviation, 1.4);
  // Said to be systematic, the same error is taken for what it is.
  auto const forgiving = fit_lj_bwr(grid, {.relative_error_floor = 0.01});
  EXPECT_LT(forgiving.chi_2 / forgiving.degrees_of_freedom, 1.2);
}

TEST(FitLjBwr, StrengthensThePriorUntilTheFitIsPhysical) {
  // Energies that fall with temperature along every isochore ask for a negative heat capacity.
  std::mt19937_64 generator(28);
  auto grid = measured_grid(LjBwr(lj_bwr_1993), {}, generator);
  for (auto& point : grid.points)
    point.U.mean = 10 - 1.5 * point.T;
  auto const fit = fit_lj_bwr(grid, {.prior_width = 10});
  EXPECT_GT(fit.strengthened, 0);
  EXPECT_LT(fit.prior_width, fit.evidence_width);
  EXPECT_TRUE(fit.stability.stable());
  EXPECT_GT(fit.chi_2 / fit.degrees_of_freedom, 100);
  // Where the published set itself is unphysical, no prior helps.
  EXPECT_THROW(fit_lj_bwr(grid, {.T_low = 0.5}), PhysicsError);
}

TEST(FitLjBwr, FromScratchRecoversTheSampledBox) {
  std::mt19937_64 generator(29);
  LjBwr const published(lj_bwr_1993);
  Campaign const campaign{.densities = 8, .temperatures = 6, .relative_noise = 0.002};
  auto const fit = fit_lj_bwr(measured_grid(published, campaign, generator), {.prior = LjBwrPrior::none});
  std::printf("from scratch: effective parameters %.1f, condition %.1e, regularised %.1e, chi^2/dof %.3f\n",
              fit.effective_parameters, fit.condition, fit.condition_regularised,
              fit.chi_2 / fit.degrees_of_freedom);
  EXPECT_NEAR(fit.chi_2 / fit.degrees_of_freedom, 1, 4 * std::sqrt(2 / fit.degrees_of_freedom));
  EXPECT_GT(fit.effective_parameters, 12);
  EXPECT_LT(fit.effective_parameters, 32);
  int cases = 0;
  for (double rho : {0.6, 0.77, 0.95})
    for (double T : {3.7, 6.2, 10.1}) {
      auto const predicted = fit.predict(rho, T);
      EXPECT_NEAR(predicted.P, published.isochore(rho).pressure(T), 4 * predicted.P_se);
      EXPECT_NEAR(predicted.P / published.isochore(rho).pressure(T), 1, 0.003);
      EXPECT_NEAR(predicted.U, published.isochore(rho).energy(T), 4 * predicted.U_se);
      ++cases;
    }
  EXPECT_EQ(cases, 9);
  // The model ends where its data end.
  EXPECT_THROW(fit.eos.isochore(1.1), PhysicsError);
}

TEST(FitLjBwr, GammaIsFoundFromPreciseData) {
  std::mt19937_64 generator(30);
  LjBwrSet set = lj_bwr_1993;
  set.gamma = 2.6;
  Eigen::Map<Eigen::VectorXd>(set.x.data(), bwr::parameters) =
      published_prior(wide_region(), set.gamma).centre;
  Campaign const campaign{.densities = 10, .temperatures = 8, .relative_noise = 1e-6};
  auto const grid = measured_grid(LjBwr(set), campaign, generator);
  auto const fixed = fit_lj_bwr(grid, {.prior = LjBwrPrior::none});
  auto const free = fit_lj_bwr(grid, {.prior = LjBwrPrior::none, .fit_gamma = true});
  std::printf("gamma %.4f (set 2.6), log evidence %.1f, %.1f at gamma 3\n", free.eos.set().gamma,
              free.log_evidence, fixed.log_evidence);
  EXPECT_NEAR(free.eos.set().gamma, 2.6, 0.1);
  EXPECT_GT(free.log_evidence, fixed.log_evidence);
}

} // namespace
} // namespace mesobridge::fitting::test
