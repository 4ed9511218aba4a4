#pragma once
#include "md/metal.hpp"

namespace mesobridge::md {

/// How a crystal comes to another density: evenly, or along z alone (md/README.md, Eq. (M15)).
enum class Squeeze { evenly, along_z };

/// Estimates for a crystal whose atoms vibrate classically about its static states: e = e_c(rho) + 3 k_B T/m,
/// P = P_c(rho) + G rho 3 k_B T/m with G = 2 (md/README.md, Eq. (M9)). They only say where to sample.
class QuasiharmonicMetal {
 public:
  QuasiharmonicMetal(MpiWorld const& world, MetalSettings const& settings);

  double zero_pressure_density(double T);
  /// Temperature behind a shock, velocity of the matter there, and P, or P_zz of what is squeezed along z.
  struct Shocked {
    double T, v_P, P;
  };
  /// Throws PhysicsError where the estimate has no solution (compressions towards 1 + 2/G).
  Shocked shocked(MetalState initial, double rho, Squeeze squeeze = Squeeze::evenly);
  /// The compression of a shock of this v_P. Throws InputError when it is out of reach.
  double compression(MetalState initial, double v_P, Squeeze squeeze = Squeeze::evenly);

 private:
  double thermal_energy(double T) const;

  MetalCrystal crystal_;
  double mass_;
};

} // namespace mesobridge::md
