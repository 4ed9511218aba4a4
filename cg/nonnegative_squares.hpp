#pragma once
#include <vector>

namespace mesobridge::cg {

/// The x >= 0 that makes x.A x/2 - b.x least, for a symmetric positive definite A (row by row): least squares
/// of coefficients that must not be negative (Lawson and Hanson 1974). Throws PhysicsError when A is not
/// positive definite.
std::vector<double> nonnegative_squares(std::vector<double> const& A, std::vector<double> const& b);

/// Likewise, with c.x = d; all c >= 0, some c and d > 0.
std::vector<double> nonnegative_squares(std::vector<double> const& A, std::vector<double> const& b,
                                        std::vector<double> const& c, double d);

} // namespace mesobridge::cg
