#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Threads that are worth waking for a layer: one for the few particles of a corner.
inline int threads_for(System const& system, WallLayer const& layer) {
  constexpr std::size_t few = 256;
  return layer.particles.size() < few ? 1 : system.threads;
}

/// Finds the images that particles see behind the walls, for the positions of now.
void find_wall_images(System& system);

/// Finds the images, and adds what they give to the particles' densities (sdpd/README.md, Eq. (S40)).
void add_wall_densities(System& system);

/// Adds the forces of pressures by the images of the last sum of the densities, and notes what each wall
/// exerts (Eq. (S41)).
void add_wall_forces(System& system);

/// Finds the images and adds the forces of the pair potential (DPD, DPDE), with its energy (Eq. (S42)).
/// Throws PhysicsError when a particle is nearer to an image than the potential is defined.
void add_wall_pair_forces(System& system);

/// Adds half of the virial of each particle and its images by the pair potential, at the images found last.
void add_wall_virials(System const& system, std::vector<double>& virial);

/// What the walls give in a kick over dt: impulse and work.
void count_wall_impulses(System& system, double dt);

/// Lets the walls move, if they are not held, and reflects particles that have come through one in its frame.
void move_walls(System& system, double dt);

} // namespace mesobridge::sdpd
