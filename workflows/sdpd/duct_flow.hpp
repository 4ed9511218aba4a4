#pragma once

namespace mesobridge::workflows {

/// Poiseuille's flow in a duct of the rectangular cross section a x b, without slip: velocities in units of
/// rho g/eta, by the series of cosines along a (sdpd/README.md, Eq. (S59)). Lengths > 0.
struct Duct {
  double a, b;

  /// The velocity at z from the wall, 0 ... a, in the mean over b, to 1e-5 of itself.
  double velocity(double z) const;
  /// That of a place, y from the wall along b.
  double velocity(double z, double y) const;
  /// In the mean over the cross section; 0.035144 a^2 in a square.
  double mean_velocity() const;
};

} // namespace mesobridge::workflows
