#pragma once
#include "sdpd/state/snapshot.hpp"
#include <cstdint>

namespace mesobridge::sdpd {

/// Slices of equal width across a box.
struct Slices {
  int axis = 0; ///< the one that they are perpendicular to: 0, 1, 2 for x, y, z
  std::size_t count = 1;
};

/// What the particles of each slice are at one instant, in reduced units. A slice without particles has the
/// number 0 and holds 0 in all that is a mean; so has T_kin with a single particle. Quantities that the
/// method does not have are empty.
struct Profile {
  std::vector<std::int64_t> number; ///< of particles
  std::vector<double> rho;    ///< mean of the particles' densities; mass per volume where they have none
  std::vector<Vec3> velocity; ///< of the slice's centre of mass
  /// sum |p - m <v>|^2/2m = 3/2 (number - 1) k_B T_kin: of the motion about the slice's own velocity.
  std::vector<double> T_kin;
  std::vector<double> T_int; ///< mean of T_i for SDPD, harmonic mean for DPDE (sdpd/README.md, Eq. (S18))
  std::vector<double> P_internal; ///< SDPD: mean of the particles' pressures
  /// Means of the fields that are profiled under their own names, in the order of `fields`.
  std::vector<std::pair<Field const*, std::vector<double>>> means;
  /// With what the moving particles carry, rho k_B T_kin / m. SDPD: beside P_internal. DPD, DPDE: beside the
  /// virials of the slice's particles over three times its volume; empty where the snapshot has none.
  std::vector<double> P;
};

/// Sums in the order of the ids, so that the result does not depend on the threads. `boltzmann` is k_B in
/// reduced units: 1/K for SDPD, 1 for DPD and DPDE. Throws InputError for an axis that there is not, or no
/// slices.
Profile profile(Snapshot const& now, Box const& box, Slices const& slices, double boltzmann);

} // namespace mesobridge::sdpd
