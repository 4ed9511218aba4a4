#pragma once
#include "sdpd/system/sub_step.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Whether a wall has friction.
bool has_rough_walls(System const& system);

/// Friction and noise of particles with the rough walls that they see images behind, and conduction of heat
/// where the fluid conducts, over dt (sdpd/README.md, Eqs. (S50) ... (S53)). Impulse, work and heat are noted
/// with each wall. `second`: of two in a step.
SubStep wall_friction(System const& system, double dt, bool second);

/// Friction coefficients of a particle with a wall, along its normal and along the wall; reduced.
struct WallWeights {
  double normal = 0, along = 0;
};

/// Of the k-th particle of the wall's layer, by its images (Eq. (S50)).
WallWeights wall_weights(System const& system, Wall const& wall, std::size_t k);

/// Velocity of the wall's plane now, at rest while the walls are held.
Vec3 wall_velocity(System const& system, Wall const& wall);

} // namespace mesobridge::sdpd
