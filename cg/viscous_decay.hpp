#pragma once
#include <span>

namespace mesobridge::cg {

/// How a transverse current dies away in a viscoelastic fluid with one memory time, cg/README.md, Eq. (C33):
/// f(t) = exp(-t/2T) [cosh(Wt/2T) + sinh(Wt/2T)/W], W^2 = 1 - 4aT. Its integral over all times is 1/a.
struct ViscousDecay {
  double rate = 1;   ///< a = eta k^2/rho > 0: how fast it dies away once the memory is gone
  double memory = 0; ///< T > 0 of the shear stress

  double operator()(double t) const;
};

/// Least squares of values at t = 0, interval, 2 interval ..., the first of which is one. At least 4 values.
/// Throws PhysicsError where they do not die away.
ViscousDecay fit_viscous_decay(std::span<double const> values, double interval);

} // namespace mesobridge::cg
