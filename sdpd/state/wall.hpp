#pragma once
#include "md/box.hpp"
#include <algorithm>
#include <cstdint>
#include <vector>

namespace mesobridge::sdpd {

/// How a wall moves along its normal, in the units of its owner: at rest, or faster and faster to a constant
/// velocity, which it has after the time `ramp`. Positive velocities go up the axis.
struct WallMotion {
  double velocity = 0;
  double ramp = 0; ///< >= 0

  double velocity_at(double time) const {
    return velocity * (time < ramp ? std::max(0.0, time) / ramp : time > 0 ? 1 : 0);
  }
  /// How far it has come.
  double way_at(double time) const {
    double const of_ramp = std::clamp(time, 0.0, ramp);
    return velocity * (ramp > 0 ? of_ramp * of_ramp / (2 * ramp) : 0) + velocity * std::max(0.0, time - ramp);
  }
};

/// The image of particle `of` behind a wall, as another particle sees it.
struct WallImage {
  std::uint32_t of;
  Vec3 r; ///< from the image to the particle that sees it
};

/// The particles that see images behind a wall, and those within their range, for the positions at the last
/// sum of the densities (with a pair potential: of the forces). Kept so that no step allocates: `images` may
/// be longer. Those that may come so near, `candidates`, are looked for when the neighbour lists were renewed
/// or the wall has moved by half their skin.
struct WallLayer {
  std::vector<std::uint32_t> particles;
  std::vector<std::vector<WallImage>> images; ///< of each of them, its own among them
  std::vector<std::uint32_t> candidates;
  std::uint64_t renewal = 0; ///< of the lists, and where the wall was, when they were found
  double position = 0;
};

/// What makes a wall rough: friction towards its velocity, with the noise of its temperature (sdpd/README.md,
/// Eq. (S50)). In the units of its owner.
struct WallFriction {
  bool acts = false;
  double temperature = 1; ///< of the wall, > 0
  double strength = 1;    ///< factor of the coefficients of friction, > 0
  Vec3 slide;             ///< velocity along the wall; its component along the normal is 0
};

/// A plane that mirrors the fluid (sdpd/README.md, Eq. (S40)): particles meet the images of themselves and of
/// each other, at the same density, pressure and temperature. Without friction it slips, and takes no heat.
/// In reduced units.
struct Wall {
  int axis = 0;       ///< 0, 1, 2: its normal is x, y, z
  bool upper = false; ///< the fluid lies below it
  double start = 0;   ///< where it is as long as it has not moved
  WallMotion motion = {};
  WallFriction friction = {};
  double force = 0;   ///< that it exerts along its normal, at the last evaluation of the forces
  double impulse = 0; ///< that its images have given to the fluid along its normal
  double work = 0;    ///< that it has done on the fluid, by images and friction
  Vec3 drag;          ///< impulse that its friction and noise have given to the fluid
  double heat = 0;    ///< that has come from it into the fluid
  WallLayer layer = {};

  double position(double time) const { return start + motion.way_at(time); }
  /// How far a place is from it, > 0 inside the fluid.
  double distance(Vec3 const& q, double time) const {
    double const x = component(q, axis) - position(time);
    return upper ? -x : x;
  }
};

} // namespace mesobridge::sdpd
