#include "fitting/held_out.hpp"
#include "fitting/linear_gaussian.hpp"
#include "md/error.hpp"
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::fitting::test {
namespace {

struct Problem {
  Eigen::MatrixXd A;
  Eigen::VectorXd r;
};

Problem random_problem(int data, int parameters, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Problem problem{Eigen::MatrixXd(data, parameters), Eigen::VectorXd(data)};
  for (auto& entry : problem.A.reshaped())
    entry = normal(generator);
  for (auto& entry : problem.r)
    entry = 3 * normal(generator);
  return problem;
}

/// The normal equations and the Gaussian density of the data, formed directly.
struct Direct {
  Eigen::MatrixXd covariance, hat;
  Eigen::VectorXd mean;
  double log_density;
};

Direct solve_directly(Problem const& p, double w) {
  auto const n = p.A.cols();
  Eigen::MatrixXd const covariance =
      (p.A.transpose() * p.A + Eigen::MatrixXd::Identity(n, n) / (w * w)).inverse();
  Eigen::MatrixXd const of_data =
      Eigen::MatrixXd::Identity(p.r.size(), p.r.size()) + w * w * p.A * p.A.transpose();
  return {covariance, p.A * covariance * p.A.transpose(), covariance * p.A.transpose() * p.r,
          -0.5 * std::log(of_data.determinant()) - 0.5 * p.r.dot(of_data.inverse() * p.r)};
}

TEST(LinearGaussian, AgreesWithTheNormalEquations) {
  int cases = 0;
  for (auto [data, parameters] : {std::pair{12, 5}, std::pair{5, 5}, std::pair{4, 9}})
    for (double w : {0.05, 1.0, 20.0}) {
      auto const problem = random_problem(data, parameters, 4 + cases);
      LinearGaussian const linear(problem.A, problem.r);
      auto const posterior = linear.posterior(w);
      auto const direct = solve_directly(problem, w);
      double const size = direct.covariance.norm();
      EXPECT_LT((posterior.mean - direct.mean).norm(), 1e-9 * (1 + direct.mean.norm()));
      EXPECT_LT((posterior.spread * posterior.spread.transpose() - direct.covariance).norm(), 1e-9 * size);
      EXPECT_LT((posterior.hat - direct.hat).norm(), 1e-9);
      EXPECT_NEAR(posterior.effective_parameters, direct.hat.trace(), 1e-9);
      EXPECT_NEAR(linear.log_evidence(w), direct.log_density, 1e-8 * std::abs(direct.log_density));
      ++cases;
    }
  EXPECT_EQ(cases, 9);
}

TEST(LinearGaussian, FindsTheWidthOfLargestEvidence) {
  // u drawn with width 0.5, 200 parameters: the evidence peaks near 0.5 (its own uncertainty is 1/sqrt(400) =
  // 5 %).
  auto problem = random_problem(400, 200, 7);
  std::mt19937_64 generator(8);
  std::normal_distribution<double> normal;
  Eigen::VectorXd u(200), noise(400);
  for (auto& x : u)
    x = 0.5 * normal(generator);
  for (auto& x : noise)
    x = normal(generator);
  problem.r = problem.A * u + noise;
  double const found = LinearGaussian(problem.A, problem.r).best_width(1e-3, 1e3);
  EXPECT_NEAR(found, 0.5, 4 * 0.025);
}

TEST(LinearGaussian, HeldOutDataAreThoseOfARefit) {
  auto const problem = random_problem(10, 4, 9);
  double const w = 0.8;
  auto const posterior = LinearGaussian(problem.A, problem.r).posterior(w);
  Eigen::VectorXd const residual = problem.r - problem.A * posterior.mean;
  std::vector<Eigen::Index> const group{2, 3, 7};
  std::vector<Eigen::Index> const rest{0, 1, 4, 5, 6, 8, 9};
  auto const held = hold_out(posterior.hat, residual, group);
  Problem const without{problem.A(rest, Eigen::all), problem.r(rest)};
  auto const refit = solve_directly(without, w);
  Eigen::MatrixXd const A_held = problem.A(group, Eigen::all);
  Eigen::VectorXd const error = Eigen::VectorXd(problem.r(group)) - A_held * refit.mean;
  Eigen::MatrixXd const covariance =
      Eigen::MatrixXd::Identity(3, 3) + A_held * refit.covariance * A_held.transpose();
  EXPECT_LT((held.error - error).norm(), 1e-12);
  EXPECT_LT((held.covariance - covariance).norm(), 1e-12);
}

TEST(LinearGaussian, ConditionNumbers) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3, 2);
  A(0, 0) = 10;
  A(1, 1) = 0.1;
  LinearGaussian const linear(A, Eigen::Vector3d(1, 1, 1));
  EXPECT_NEAR(linear.condition(), 100, 1e-10);
  EXPECT_NEAR(linear.condition(1), std::sqrt(101 / 1.01), 1e-10);
  EXPECT_TRUE(std::isinf(LinearGaussian(A.transpose(), Eigen::Vector2d(1, 1)).condition()));
}

TEST(LinearGaussian, RefusesNan) {
  EXPECT_THROW(LinearGaussian(Eigen::MatrixXd::Constant(2, 2, NAN), Eigen::Vector2d(1, 1)), InputError);
  EXPECT_THROW(LinearGaussian(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(1, NAN)), InputError);
  EXPECT_THROW(LinearGaussian(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector3d(1, 1, 1)), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
