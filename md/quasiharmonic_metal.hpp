#pragma once
#include "md/metal.hpp"

namespace mesobridge::md {

/// Estimates for a crystal whose atoms vibrate classically about its static states: e = e_c(rho) + 3 k_B T/m,
/// P = P_c(rho) + G rho 3 k_B T/m with G = 2 (md/README.md, Eq. (M9)). They only say where to sample.
class QuasiharmonicMetal {
 public:
  QuasiharmonicMetal(MpiWorld const& world, MetalSettings const& settings);

  double zero_pressure_density(double T);
  /// Temperature behind a shock, and velocity of the matter there.
  struct Shocked {
    double T, v_P;
  };
  /// Throws PhysicsError where the estimate has no solution (compressions towards 1 + 2/G).
  Shocked shocked(MetalState initial, double rho);
  /// The compression of a shock of this v_P. Throws InputError when it is out of reach.
  double compression(MetalState initial, double v_P);

 private:
  double thermal_energy(double T) const;

  MetalCrystal crystal_;
  double mass_;
};

} // namespace mesobridge::md
