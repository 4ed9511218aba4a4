#pragma once
#include "fitting/eigen.hpp"
#include "fitting/eos/bwr_terms.hpp"

namespace mesobridge::fitting {

/// U - (3/2) T and P - rho T of the BWR equation are linear in its parameters: residual = rows * x.
/// Lennard-Jones units, per atom.
struct ResidualRows {
  Eigen::Matrix<double, 1, bwr::parameters> U, P;
};

/// Rows of the state (rho, T), both > 0, T at or above T_low.
ResidualRows residual_rows(double rho, double T, double gamma);

} // namespace mesobridge::fitting
