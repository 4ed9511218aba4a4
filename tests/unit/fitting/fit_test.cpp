#include "fitting/fit.hpp"
#include "md/error.hpp"
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::fitting::test {
namespace {

Parameter parameter(std::string name, double start, double lower, double upper, bool logarithmic = false) {
  return {.name = name,
          .key = name,
          .unit = "",
          .meaning = "",
          .start = start,
          .lower = lower,
          .upper = upper,
          .logarithmic = logarithmic};
}

/// Data of one of NIST's Statistical Reference Datasets and a model y = f(b, x) for them.
struct Nist {
  std::vector<double> y, x;
  std::function<double(Eigen::VectorXd const&, double)> model;

  double noise; ///< certified standard deviation of the residuals

  FitProblem problem(std::vector<Parameter> parameters) const {
    return {std::move(parameters), [this](Eigen::VectorXd const& b) {
              Eigen::VectorXd r(y.size());
              for (std::size_t i = 0; i < y.size(); ++i)
                r[i] = (y[i] - model(b, x[i])) / noise;
              return r;
            }};
  }
};

/// Misra1a: b1 (1 - exp(-b2 x)).
Nist misra1a() {
  return {{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78},
          {77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0},
          [](Eigen::VectorXd const& b, double x) { return b[0] * -std::expm1(-b[1] * x); },
          1.0187876330e-1};
}

/// MGH09: b1 (x^2 + b2 x)/(x^2 + b3 x + b4), of higher difficulty.
Nist mgh09() {
  return {{0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246},
          {4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625},
          [](Eigen::VectorXd const& b, double x) {
            return b[0] * (x * x + b[1] * x) / (x * x + b[2] * x + b[3]);
          },
          6.6279236551e-3};
}

void expect_certified(FitOutcome const& found, std::vector<double> const& values,
                      std::vector<double> const& errors) {
  EXPECT_NEAR(found.chi_2() / found.degrees_of_freedom(), 1, 1e-8);
  EXPECT_TRUE(found.converged);
  EXPECT_TRUE(found.undetermined().empty());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(found.values[i] / values[i], 1, 1e-6);
    EXPECT_NEAR(found.se(i) / errors[i], 1, 1e-5);
  }
}

TEST(Fit, FindsTheCertifiedAnswersOfMisra1a) {
  auto const data = misra1a();
  auto const problem =
      data.problem({parameter("b1", 500, 10, 1000, true), parameter("b2", 1e-4, 1e-6, 1e-1, true)});
  std::vector<double> const values{2.3894212918e2, 5.5015643181e-4}, errors{2.7070075241, 7.2668688436e-6};
  expect_certified(fit(problem), values, errors);
  expect_certified(fit(problem, {.global_evaluations = 0}), values, errors);
}

TEST(Fit, FindsTheCertifiedAnswersOfMgh09) {
  auto const data = mgh09();
  auto const problem =
      data.problem({parameter("b1", 25, 1e-3, 30, true), parameter("b2", 39, 1e-3, 50, true),
                    parameter("b3", 41.5, 1e-3, 50, true), parameter("b4", 39, 1e-3, 50, true)});
  expect_certified(fit(problem), {1.9280693458e-1, 1.9128232873e-1, 1.2305650693e-1, 1.3606233068e-1},
                   {1.1435312227e-2, 1.9633220911e-1, 8.0842031232e-2, 9.0025542308e-2});
}

TEST(Fit, TheGlobalSearchLeavesALocalMinimum) {
  // sin(w x) with the wrong frequency to start from: a local descent ends in a side lobe.
  std::vector<double> x;
  for (int i = 0; i < 60; ++i)
    x.push_back(0.1 * i);
  FitProblem const problem{{parameter("w", 9, 0.5, 20)}, [&](Eigen::VectorXd const& p) {
                             Eigen::VectorXd r(x.size());
                             for (std::size_t i = 0; i < x.size(); ++i)
                               r[i] = (std::sin(3 * x[i]) - std::sin(p[0] * x[i])) / 0.01;
                             return r;
                           }};
  EXPECT_GT(std::abs(fit(problem, {.global_evaluations = 0}).values[0] - 3), 1);
  EXPECT_NEAR(fit(problem).values[0], 3, 1e-8);
}

/// y = a + b x at x = 0 ... 9, noise 1.
FitProblem line(Eigen::VectorXd const& y, std::vector<Parameter> parameters) {
  return {std::move(parameters), [y](Eigen::VectorXd const& p) {
            Eigen::VectorXd r(y.size());
            for (Eigen::Index i = 0; i < y.size(); ++i)
              r[i] = y[i] - p[0] - p[1] * static_cast<double>(i);
            return r;
          }};
}

TEST(Fit, ErrorsAndCorrelationOfAStraightLineAreTheTextbookOnes) {
  Eigen::VectorXd const y = Eigen::VectorXd::LinSpaced(10, 1, 19);
  auto const found = fit(line(y, {parameter("a", 0, -100, 100), parameter("b", 0, -100, 100)}));
  // n = 10, sum x = 45, sum x^2 = 285: var a = 285/825, var b = 10/825, cov = -45/825.
  EXPECT_NEAR(found.values[0], 1, 1e-8);
  EXPECT_NEAR(found.values[1], 2, 1e-8);
  EXPECT_NEAR(found.se(0), std::sqrt(285.0 / 825), 1e-6);
  EXPECT_NEAR(found.se(1), std::sqrt(10.0 / 825), 1e-6);
  // At x = 3 the variance is 285/825 - 6 * 45/825 + 9 * 10/825.
  auto const at_3 = [](Eigen::VectorXd const& p) { return p[0] + 3 * p[1]; };
  EXPECT_NEAR(found.se_of(at_3), std::sqrt((285.0 - 6 * 45 + 90) / 825), 1e-6);
  EXPECT_NEAR(found.correlation()(0, 1), -45 / std::sqrt(285.0 * 10), 1e-6);
  EXPECT_TRUE(found.undetermined().empty());
}

TEST(Fit, FixedParametersStayAndABoundThatHoldsIsTold) {
  Eigen::VectorXd const y = Eigen::VectorXd::LinSpaced(10, 1, 19);
  auto fixed = parameter("b", 1.5, 0, 0);
  fixed.free = false;
  auto const found = fit(line(y, {parameter("a", 0, -100, 100), fixed}));
  EXPECT_EQ(found.values[1], 1.5);
  EXPECT_EQ(found.se(1), 0);
  EXPECT_NEAR(found.values[0], 1 + 0.5 * 4.5, 1e-8);
  auto const bounded = fit(line(y, {parameter("a", 0, -100, 100), parameter("b", 0, -1, 1.5)}));
  ASSERT_EQ(bounded.at_bound.size(), 1u);
  EXPECT_EQ(bounded.at_bound[0], 1);
  EXPECT_NEAR(bounded.values[1], 1.5, 1e-6);
  EXPECT_NEAR(bounded.values[0], 1 + 0.5 * 4.5, 1e-5);
}

TEST(Fit, AConstraintIsKeptWhereItBites) {
  // a + b <= 2 against data that want a + b = 3: Lagrange's answer by hand is the constrained least squares.
  Eigen::VectorXd const y = Eigen::VectorXd::LinSpaced(10, 1, 19);
  auto problem = line(y, {parameter("a", 0, -100, 100), parameter("b", 0, -100, 100)});
  problem.constraints = [](Eigen::VectorXd const& p) {
    return Eigen::VectorXd::Constant(1, 2 - p[0] - p[1]);
  };
  auto const found = fit(problem);
  // min of (a-1, b-2) H (a-1, b-2)^T on a + b = 2, H = [[10, 45], [45, 285]]: step = -H^-1 n/(n H^-1 n), n =
  // (1, 1)
  double const n_H_n = (285.0 - 2 * 45 + 10) / 825;
  EXPECT_NEAR(found.values[0], 1 - (285.0 - 45) / 825 / n_H_n, 1e-5);
  EXPECT_NEAR(found.values[1], 2 - (10.0 - 45) / 825 / n_H_n, 1e-5);
  EXPECT_LE(found.values[0] + found.values[1], 2);
  EXPECT_TRUE(found.constrained);
  EXPECT_TRUE(found.converged);
}

TEST(Fit, SaysWhatTheDataDoNotDetermine) {
  // Only a + b and nothing of c enters.
  FitProblem const problem{{parameter("a", 0.5, 0, 10), parameter("b", 0.5, 0, 10), parameter("c", 1, 0, 10)},
                           [](Eigen::VectorXd const& p) {
                             Eigen::VectorXd r(4);
                             r << p[0] + p[1] - 5, p[0] + p[1] - 5.1, p[0] + p[1] - 4.9, p[0] + p[1] - 5;
                             return Eigen::VectorXd(r / 0.1);
                           }};
  auto const found = fit(problem);
  EXPECT_FALSE(found.determined(0));
  EXPECT_FALSE(found.determined(1));
  EXPECT_FALSE(found.determined(2));
  auto const words = found.undetermined();
  ASSERT_EQ(words.size(), 2u);
  auto const all = words[0] + words[1];
  EXPECT_NE(all.find("a, b"), std::string::npos) << all;
  EXPECT_NE(all.find("not determine c"), std::string::npos) << all;
  EXPECT_NEAR(found.values[0] + found.values[1], 5, 1e-6);
  // The sum is known to 0.1/2 whatever its parts.
  Eigen::Vector3d const sum(1, 1, 0);
  EXPECT_NEAR(std::sqrt(sum.dot(found.covariance() * sum)), 0.05, 1e-4);
}

TEST(Fit, IsDeterministicForASeed) {
  auto const data = mgh09();
  auto const problem =
      data.problem({parameter("b1", 25, 1e-3, 30, true), parameter("b2", 39, 1e-3, 50, true),
                    parameter("b3", 41.5, 1e-3, 50, true), parameter("b4", 39, 1e-3, 50, true)});
  EXPECT_EQ(fit(problem, {.seed = 5}).values, fit(problem, {.seed = 5}).values);
  auto const best = fit(problem, {.seed = 5});
  EXPECT_NE(best.evaluations, fit(problem, {.seed = 6}).evaluations);
  EXPECT_EQ(
      bootstrap(line(Eigen::VectorXd::Zero(10), {parameter("a", 0, -9, 9), parameter("b", 0, -9, 9)}),
                fit(line(Eigen::VectorXd::Zero(10), {parameter("a", 0, -9, 9), parameter("b", 0, -9, 9)})), 3,
                7)
          .values.rows(),
      3);
}

TEST(Fit, TheBootstrapOfALinearModelHasItsErrors) {
  Eigen::VectorXd const y = Eigen::VectorXd::LinSpaced(10, 1, 19);
  auto const problem = line(y, {parameter("a", 0, -100, 100), parameter("b", 0, -100, 100)});
  auto const best = fit(problem);
  auto const drawn = bootstrap(problem, best, 400, 3);
  EXPECT_EQ(drawn.values.rows(), 400);
  EXPECT_EQ(drawn.failed, 0);
  for (Eigen::Index k = 0; k < 2; ++k) {
    // A standard deviation of 400 normal numbers is known to 1/sqrt(800) = 3.5 %.
    EXPECT_NEAR(drawn.se(k) / best.se(k), 1, 0.12);
    EXPECT_NEAR(drawn.quantile(k, 0.5), best.values[k], 0.2 * best.se(k));
  }
}

TEST(Fit, RefusesBadInputByName) {
  Eigen::VectorXd const y = Eigen::VectorXd::Zero(10);
  auto refuses = [&](std::vector<Parameter> parameters, std::string const& words) {
    try {
      fit(line(y, std::move(parameters)));
      ADD_FAILURE() << "accepted: " << words;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refuses({parameter("a", 0, 1, -1), parameter("b", 0, -9, 9)}, "parameter a bounds = 1:-1");
  refuses({parameter("a", 0, -1, 1), parameter("b", 10, -9, 9)}, "parameter b start = 10");
  refuses({parameter("a", 0, -1, 1, true), parameter("b", 0, -9, 9)}, "parameter a lower bound = -1");
  auto a = parameter("a", 0, 0, 0), b = a;
  a.free = b.free = false;
  refuses({a, b}, "at least one parameter must be free");
  FitProblem const hopeless{{parameter("a", 0.5, 0, 1)}, [](Eigen::VectorXd const&) -> Eigen::VectorXd {
                              throw PhysicsError("no answer");
                            }};
  EXPECT_THROW(fit(hopeless), PhysicsError);
  EXPECT_THROW(fit(hopeless, {.global_evaluations = 0}), PhysicsError);
}

/// y = a exp(-b x) + c exp(-d x) at twenty points, of a = 3, b = 0.5, c = 200, d = 7; 1 % errors, no noise.
FitProblem two_exponentials(bool linear) {
  auto const model = [](Eigen::VectorXd const& p, double x) {
    return p[0] * std::exp(-p[1] * x) + p[2] * std::exp(-p[3] * x);
  };
  std::vector<Parameter> parameters{parameter("a", 1, 1e-3, 1e3, true), parameter("b", 1, 0.1, 3),
                                    parameter("c", 1, 1e-3, 1e6, true), parameter("d", 5, 3, 30)};
  parameters[0].linear = parameters[2].linear = linear;
  return {parameters, [model](Eigen::VectorXd const& p) {
            Eigen::VectorXd r(20);
            for (Eigen::Index i = 0; i < r.size(); ++i) {
              double const x = 0.1 * double(i), y = model(Eigen::Vector4d(3, 0.5, 200, 7), x);
              r[i] = (model(p, x) - y) / (0.01 * y);
            }
            return r;
          }};
}

TEST(Fit, EliminatesLinearParametersFromTheSearch) {
  for (std::uint64_t seed : {1, 2, 3}) {
    auto const found = fit(two_exponentials(true), {.seed = seed, .global_evaluations = 400});
    EXPECT_LT(found.chi_2(), 1e-8) << seed;
    EXPECT_NEAR(found.values[2], 200, 1e-3);
    EXPECT_EQ(found.starts, 8);
    EXPECT_EQ(found.starts_at_best, 8) << seed;
  }
}

TEST(Fit, EndsWhenItIsTold) {
  int asked = 0;
  FitOptions const options{.keep_going = [&] { return ++asked < 300; }};
  EXPECT_THROW(fit(two_exponentials(true), options), Interrupted);
  EXPECT_THROW(fit(two_exponentials(false), options), Interrupted);
  auto const problem = two_exponentials(false);
  auto const best = fit(problem);
  asked = 0;
  EXPECT_THROW(bootstrap(problem, best, 1'000'000, 1, options.keep_going), Interrupted);
  EXPECT_EQ(asked >= 300, true);
}

TEST(Fit, FewerDataThanParametersAreRefused) {
  FitProblem const problem{
      {parameter("a", 0.5, 0, 1), parameter("b", 0.5, 0, 1)},
      [](Eigen::VectorXd const& p) { return Eigen::VectorXd::Constant(1, p[0] + p[1]); }};
  EXPECT_THROW(fit(problem), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
