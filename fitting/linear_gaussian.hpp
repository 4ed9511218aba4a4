#pragma once
#include "fitting/eigen.hpp"

namespace mesobridge::fitting {

/// What the data leave of u: its distribution, and the projection of the data on the fit.
struct LinearPosterior {
  Eigen::VectorXd mean;
  Eigen::MatrixXd spread;      ///< covariance = spread * spread^T
  Eigen::MatrixXd hat;         ///< fitted = hat * data
  double effective_parameters; ///< trace of hat
};

/// Bayesian linear regression of whitened data: r = A u + noise of unit variance, u ~ N(0, w^2 I), for any
/// prior width w > 0, by one singular value decomposition (fitting/README.md, Eq. (F19)).
class LinearGaussian {
 public:
  /// A: data x parameters; r: data. Throws InputError when an entry is not finite.
  LinearGaussian(Eigen::MatrixXd const& A, Eigen::VectorXd const& r);

  /// ln p(r | w) up to a constant that does not depend on w or A.
  double log_evidence(double w) const;
  /// The width of largest evidence in [low, high], to 1.5 %.
  double best_width(double low, double high) const;
  LinearPosterior posterior(double w) const;
  /// Condition number of A (infinite when it lacks rank), and of A with the prior's rows below it.
  double condition() const;
  double condition(double w) const;

 private:
  Eigen::Index parameters_;
  Eigen::VectorXd singular_; // descending, one a parameter (zeros when there are fewer data)
  Eigen::MatrixXd left_, right_;
  Eigen::VectorXd projected_;
  double outside_; // squared length of the data outside the columns of A
};

} // namespace mesobridge::fitting
