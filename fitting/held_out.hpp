#pragma once
#include "fitting/eigen.hpp"
#include <vector>

namespace mesobridge::fitting {

/// Prediction of data that a regularised linear fit did not see, without refitting.
struct HeldOut {
  Eigen::VectorXd error;      ///< data minus prediction
  Eigen::MatrixXd covariance; ///< of that error: noise of the data plus uncertainty of the prediction
};

/// For whitened data r of unit noise and the hat matrix H of the fit at a fixed prior, the rows of one group
/// left out together have prediction errors (I - H_gg)^-1 (r - H r)_g with covariance (I - H_gg)^-1: exact,
/// by the matrix inversion lemma (fitting/README.md, Eq. (F20)).
inline HeldOut hold_out(Eigen::MatrixXd const& H, Eigen::VectorXd const& residual,
                        std::vector<Eigen::Index> const& group) {
  Eigen::MatrixXd const rest =
      Eigen::MatrixXd::Identity(group.size(), group.size()) - Eigen::MatrixXd(H(group, group));
  Eigen::MatrixXd const covariance = rest.inverse();
  return {covariance * Eigen::VectorXd(residual(group)), covariance};
}

} // namespace mesobridge::fitting
