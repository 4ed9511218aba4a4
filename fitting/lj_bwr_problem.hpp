#pragma once
#include "fitting/linear_gaussian.hpp"
#include "fitting/lj_bwr_data.hpp"
#include "fitting/lj_bwr_prior.hpp"

namespace mesobridge::fitting {

/// Few states cannot determine 32 parameters: the prior says what holds where the data are silent.
enum class LjBwrPrior {
  /// The published equation of 1993, uncertain by the prior width (relative) in U and P over a wide region.
  published,
  /// Nothing but the form: parameters about zero, each scaled by what it does to U and P in the sampled box.
  /// The result is meant for the sampled box only.
  none
};

/// The fit at one gamma as a whitened linear problem r = A u + noise of unit variance, u = R (x - centre).
struct LjBwrProblem {
  double gamma;
  ParameterPrior prior;
  Eigen::MatrixXd A;
  Eigen::VectorXd r;
  LinearGaussian linear;
};

/// region: where the prior is stated.
LjBwrProblem whiten(std::vector<LjBwrDatum> const& data, LjBwrPrior kind, LjRegion const& region,
                    double gamma);

/// The prior widths to choose from.
struct WidthBounds {
  double low, high;
};

/// gamma in [2, 4] of largest evidence, to 1e-3 (NLopt, COBYLA), each at its own best prior width.
double best_gamma(std::vector<LjBwrDatum> const& data, LjBwrPrior kind, LjRegion const& region,
                  WidthBounds widths);

} // namespace mesobridge::fitting
