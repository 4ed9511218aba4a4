#pragma once
#include "sdpd/system/sub_step.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Whether a wall has friction.
bool has_rough_walls(System const& system);

/// Boltzmann's constant of the noise: 0 in a fluid without any.
double noise_boltzmann(System const& system);

/// Friction and noise of particles with the rough walls that they see images behind, and conduction of heat
/// where the fluid conducts and the wall has a bath, over dt (sdpd/README.md, Eqs. (S50) ... (S53), (S57)).
/// Impulse, work and heat are noted with each wall. `second`: of two in a step. Where walls meet, each has
/// its own friction, and images behind several have none.
SubStep wall_friction(System const& system, double dt, bool second);

/// Friction coefficients of a particle with a wall, along its normal and along the wall; reduced.
struct WallWeights {
  double normal = 0, along = 0;
};

/// Of the k-th particle of the wall's layer, by its images (Eq. (S50)), at the wall's temperature or another.
WallWeights wall_weights(System const& system, Wall const& wall, std::size_t k);
WallWeights wall_weights(System const& system, Wall const& wall, std::size_t k, double T);

/// What a wall has given to one particle.
struct GivenByWall {
  Vec3 impulse = {};
  double work = 0, heat = 0;
};

/// The step of friction and noise with a wall that has no bath: what the motion about the wall's velocity
/// loses is the particle's own heat (Eq. (S57)). The step is made or not, so that it leaves the invariant
/// measure alone at any dt, and energies never leave the equation of state.
GivenByWall rub_without_bath(System& system, Wall const& wall, std::size_t k, double dt,
                             NoiseSource const& of_friction, NoiseSource const& of_acceptance);

/// Velocity of the wall's plane now, at rest while the walls are held.
Vec3 wall_velocity(System const& system, Wall const& wall);

} // namespace mesobridge::sdpd
