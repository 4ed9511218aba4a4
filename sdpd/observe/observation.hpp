#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// The state of the whole system at one instant, in reduced units.
struct Observation {
  std::uint64_t step = 0;
  double kinetic = 0;   ///< sum p^2/2m
  double internal = 0;  ///< sum eps
  double potential = 0; ///< of the pair potential
  double chemical = 0;  ///< that a reaction has still to give
  double wall_work = 0; ///< done on the fluid by its walls so far
  double given = 0; ///< to the fluid from outside so far: that work, the walls' heat, the body force's work
  double T_kin =
      0; ///< kinetic temperature, of the 3(N-1) degrees of freedom that a fixed total momentum leaves
  /// Internal temperature: the arithmetic mean of T_i for SDPD, the harmonic one for DPDE
  /// (sdpd/README.md, Eq. (S18)), 0 for DPD, which has none.
  double T_int = 0;
  double P = 0;        ///< N k_B T_kin / V + virial / 3V
  double rho = 0;      ///< mean of the particles' densities; mass per volume where they have none
  double progress = 0; ///< of a reaction, the mean over the mass
  Vec3 momentum;       ///< total

  /// What is conserved: the total energy, less what has come from outside.
  double energy() const { return kinetic + internal + potential + chemical - given; }
};

/// Sums in the order of the ids, so that the result does not depend on the threads nor on the order in
/// memory.
Observation observe(System const& system);

} // namespace mesobridge::sdpd
