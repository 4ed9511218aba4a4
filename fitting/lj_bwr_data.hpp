#pragma once
#include "cg/state_grid.hpp"
#include "fitting/eigen.hpp"
#include <vector>

namespace mesobridge::fitting {

/// One state of a grid as the fit sees it: the residual parts of U and P and their covariance.
struct LjBwrDatum {
  double rho, T;
  Eigen::Vector2d y;        ///< U, P
  Eigen::Vector2d residual; ///< U - (3/2) T, P - rho T
  Eigen::Matrix2d noise;    ///< lower Cholesky factor of the covariance, systematic floor included
};

/// Checks a grid and prepares it. relative_error_floor: see LjBwrFitOptions. Throws InputError that names the
/// state and what is wrong with it: data not finite, rho or T not > 0, T below T_low, standard errors not >
/// 0, a covariance that is none.
std::vector<LjBwrDatum> prepare_lj_bwr_data(cg::StateGrid const& grid, double T_low,
                                            double relative_error_floor);

} // namespace mesobridge::fitting
