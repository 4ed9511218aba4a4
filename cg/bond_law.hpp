#pragma once
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::cg {

/// The energy of a bond of length r: harmonic, k (r - l)^2 / 2, or finitely extensible (FENE; Kremer and
/// Grest, J. Chem. Phys. 92, 5057 (1990)) as LAMMPS has it, -K R0^2 ln(1 - (r/R0)^2) / 2 with the repulsion
/// 4 epsilon ((sigma/r)^12 - (sigma/r)^6) + epsilon of bonded atoms nearer than 2^(1/6) sigma.
class BondLaw {
 public:
  /// k >= 0, l >= 0.
  static BondLaw harmonic(double k, double l) { return {k, l, 0, 0, 0}; }
  /// K > 0, R0 > 0, epsilon >= 0, sigma >= 0.
  static BondLaw fene(double K, double R0, double epsilon, double sigma) {
    return {K, 0, R0, epsilon, sigma};
  }

  /// Throws PhysicsError when the bond is longer than it can be.
  double energy(double r) const {
    if (R0_ == 0)
      return k_ / 2 * (r - l_) * (r - l_);
    double const left = 1 - r * r / (R0_ * R0_);
    if (!(left > 0))
      throw PhysicsError(fmt::format(
          "a FENE bond is {:.4g} long, its R0 is {:.4g}: the bonds or units of the mapping are not those of "
          "the trajectory",
          r, R0_));
    return -k_ / 2 * R0_ * R0_ * std::log(left) + repulsion(r);
  }

  double stiffness() const { return k_; }               ///< k or K
  double length() const { return R0_ == 0 ? l_ : R0_; } ///< l or R0

 private:
  BondLaw(double k, double l, double R0, double epsilon, double sigma)
      : k_(k), l_(l), R0_(R0), epsilon_(epsilon), sigma_(sigma) {}

  double repulsion(double r) const {
    double const s3 = std::pow(sigma_ / r, 3), s6 = s3 * s3;
    return 2 * s6 > 1 ? 4 * epsilon_ * (s6 * s6 - s6) + epsilon_ : 0;
  }

  double k_, l_, R0_, epsilon_, sigma_;
};

/// Between two atoms of a molecule, counted from 0.
struct Bond {
  int a = 0, b = 0;
  BondLaw law = BondLaw::harmonic(0, 0);
};

} // namespace mesobridge::cg
