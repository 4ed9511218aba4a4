#pragma once
#include "fitting/fluid.hpp"

namespace mesobridge::fitting {

/// The states of a fluid that have the entropy of a given one: what it passes through in a smooth compression
/// or a rarefaction wave.
class Isentrope {
 public:
  Isentrope(Fluid fluid, EosState const& from);

  /// Throws PhysicsError outside the model.
  EosState at_density(double rho) const;
  /// The first state of that pressure on the way from the given one, with a sound speed. Throws PhysicsError
  /// when the isentrope leaves the model or turns unstable (a liquid pulled beyond its strength) before.
  EosState at_pressure(double P) const;
  /// Integral of c drho/rho from rho_a to rho_b: the change of velocity across a simple wave. Relative error
  /// 1e-9 or less. Throws PhysicsError where there is no sound speed.
  double velocity_change(double rho_a, double rho_b) const;

  EosState const& from() const { return from_; }

 private:
  Fluid fluid_;
  EosState from_;
};

} // namespace mesobridge::fitting
