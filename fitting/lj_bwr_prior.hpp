#pragma once
#include "fitting/eigen.hpp"
#include "fitting/eos/lj_bwr_stability.hpp"

namespace mesobridge::fitting {

/// A Gaussian prior of the parameters: R (x - centre) ~ N(0, w^2 I) with R upper triangular.
struct ParameterPrior {
  Eigen::VectorXd centre;
  Eigen::MatrixXd R;
};

/// The published equation, uncertain in what it predicts rather than in its parameters: over a grid of 32 x
/// 24 states of the region, the prior's rms relative uncertainty of U (in units of max(|U|, T)) and P (of
/// max(|P|, rho T)) is w. This is a g-prior (Zellner 1986). The cold and dense edges carry much of that mean;
/// inside, it is surer than w. At another gamma than the published one the centre is the set that predicts
/// the published U and P best.
ParameterPrior published_prior(LjRegion const& region, double gamma);

/// Parameters about zero, each with the width that changes U and P over the region by w times max(T, rho T).
ParameterPrior wide_prior(LjRegion const& region, double gamma);

} // namespace mesobridge::fitting
