#pragma once
#include "fitting/eigen.hpp"
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::fitting {

/// One parameter of a model that is fitted. Values and bounds in the parameter's own unit.
struct Parameter {
  std::string name; ///< "K_s"
  std::string key;  ///< "K_s_Pa": with its unit, as in files
  std::string unit; ///< "Pa"; empty for pure numbers
  std::string meaning;
  double start, lower, upper;
  bool logarithmic = false; ///< searched by its logarithm: for positive ones that may span decades
  bool free = true;         ///< otherwise it stays at `start`
  bool linear = false;      ///< residuals are about linear in it while the others stand
};

/// What is fitted: minimise |residuals|^2 subject to the bounds and to constraints > 0.
struct FitProblem {
  using Function = std::function<Eigen::VectorXd(Eigen::VectorXd const&)>;

  std::vector<Parameter> parameters;
  /// (data - model)/noise, whitened to unit variance, as a function of all parameters. May throw PhysicsError
  /// or InputError where the model has no answer: such parameters are taken as infeasible.
  Function residuals;
  /// Each component is positive where the model is physical; empty: no constraints.
  Function constraints = nullptr;
};

struct FitOptions {
  std::uint64_t seed = 1;
  /// Evaluations of the global search over the box of the bounds; 0: local search from the start values.
  int global_evaluations = 20000;
  /// Asked at every evaluation; once it says no, the fit ends by Interrupted. Empty: always yes.
  std::function<bool()> keep_going = nullptr;
};

/// One principal axis of what the data say about the free parameters, in coordinates where the bounds (of
/// their logarithms, where logarithmic) are 0 and 1.
struct FitAxis {
  double sd; ///< standard deviation along the axis by the data alone; infinite if they say nothing
  Eigen::VectorXd components; ///< unit vector, one component a free parameter
  /// Bounds are a uniform distribution of this standard deviation: an axis that the data leave wider is
  /// theirs.
  static constexpr double of_bounds = 0.28867513459481287; // 1/sqrt(12)
  bool determined() const { return sd < of_bounds; }
};

struct FitOutcome {
  std::vector<Parameter> parameters;
  std::vector<Eigen::Index> free; ///< which of them were fitted
  Eigen::VectorXd values;         ///< all parameters
  /// Lower triangular L of the covariance L L^T of the free parameters, from the Gauss-Newton Hessian at the
  /// best fit. Along axes that the data do not determine it is that of the bounds.
  Eigen::MatrixXd covariance_factor;
  std::vector<FitAxis> axes;          ///< best determined first
  Eigen::VectorXd residuals;          ///< whitened, at the best fit
  std::vector<Eigen::Index> at_bound; ///< free parameters that ended on a bound: their errors are one-sided
  bool constrained = false;           ///< a constraint holds the fit off a better one
  bool converged = false;             ///< no step would lower chi^2 by more than 1e-6
  int evaluations = 0;
  int starts = 1;         ///< independent searches
  int starts_at_best = 1; ///< those that ended at the best chi^2, to 1e-3 (1 + chi^2)

  double chi_2() const { return residuals.squaredNorm(); }
  int degrees_of_freedom() const {
    return static_cast<int>(residuals.size()) - static_cast<int>(free.size());
  }
  Eigen::MatrixXd covariance() const { return covariance_factor * covariance_factor.transpose(); }
  /// Standard error of parameter i (0 for fixed ones) and correlation of two free ones.
  double se(Eigen::Index parameter) const;
  Eigen::MatrixXd correlation() const;
  /// Whether the data determine parameter i better than its bounds; true for fixed ones.
  bool determined(Eigen::Index parameter) const;
  /// Standard error that the fit leaves to a function of all parameters, linearised.
  double se_of(std::function<double(Eigen::VectorXd const&)> const& function) const;
  /// What the data do not determine, in words; empty if nothing.
  std::vector<std::string> undetermined() const;
};

/// Several global searches by controlled random search (NLopt's CRS2, seeded) over the parameters that are
/// not linear, the linear ones eliminated by least squares (variable projection); from the end of each, and
/// from the start values, Levenberg-Marquardt (GSL) on what no bound holds; from the best of these a local
/// search with the constraints by SLSQP. The same seed gives the same bits.
///
/// Throws InputError for bounds that are not in order, starts outside them, fewer residuals than free
/// parameters; PhysicsError when no feasible parameters are found; Interrupted.
FitOutcome fit(FitProblem const& problem, FitOptions const& options = {});

/// Refits of data drawn anew from the best fit and the stated noise (parametric bootstrap): what the errors
/// are when the model is not linear in its parameters.
struct Bootstrap {
  Eigen::MatrixXd values; ///< one row a refit that succeeded, one column a free parameter
  int failed = 0;         ///< refits without a result

  double se(Eigen::Index column) const;
  double quantile(Eigen::Index column, double p) const;
};

/// Throws Interrupted once keep_going, if there is one, says no.
Bootstrap bootstrap(FitProblem const& problem, FitOutcome const& best, int repeats, std::uint64_t seed,
                    std::function<bool()> const& keep_going = nullptr);

} // namespace mesobridge::fitting
