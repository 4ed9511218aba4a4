#pragma once
#include <functional>

namespace mesobridge::fitting {

/// The integral of f from a to b (either may be the larger) by GSL's adaptive Gauss-Kronrod rule, to a
/// relative error of 1e-12. What f throws is passed on; PhysicsError if the integral does not converge.
double integral(std::function<double(double)> const& f, double a, double b);

} // namespace mesobridge::fitting
