#pragma once
#include "cg/entropy.hpp"

namespace mesobridge::cg {

/// Least squares of (n/2 - 1)/E_kin, n = 3 atoms - 3, on the slopes of the basis, sum_j theta_j phi_j'(U):
/// its conditional mean at U is 1/T(U).
Sums kinetic_sums(EntropyCurve::Basis const& basis, std::span<EnergySamples const> samples, std::size_t block,
                  int atoms);

/// Adds one sample to the normal equations: X^T X and then X^T y.
void add_sample(Sums& sums, std::vector<double> const& x, double y);

std::vector<double> solve_regression(Sums const& sums, std::size_t order);

/// Solves A x = b for a symmetric positive definite A (row by row). Throws PhysicsError when it is not.
std::vector<double> solve_symmetric(std::vector<double> const& A, std::vector<double> const& b);

} // namespace mesobridge::cg
