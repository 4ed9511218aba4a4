#pragma once
#include "sdpd/thermodynamics/thermodynamics.hpp"

namespace mesobridge::sdpd {

/// A particle's state before it is heated. The temperature may be that of a caloric expansion, right to
/// caloric_reach^3.
struct HeatOrigin {
  double eps, T;
};

/// What models offer beside Thermodynamics that are at one density when they invert an energy: a state beside
/// another one of the same particle, whose energy is not inverted once more.
class HeatedStates {
 public:
  /// Of particle i with some heat more; S counts from the origin. T is looked for from T_guess, any number.
  /// Throws PhysicsError.
  virtual ThermalState heated(Particles const& particles, Index i, HeatOrigin const& from, double heat,
                              double T_guess) const = 0;

 protected:
  ~HeatedStates() = default;
};

} // namespace mesobridge::sdpd
