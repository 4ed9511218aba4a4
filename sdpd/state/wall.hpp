#pragma once
#include "md/box.hpp"
#include "sdpd/state/wall_motion.hpp"
#include <array>
#include <cstdint>
#include <vector>

namespace mesobridge::sdpd {

/// Images that particles see, those of one particle after those of another, in whole registers: what is left
/// over of the last one of a particle holds phantoms, which count for nothing.
struct WallImages {
  std::vector<std::uint32_t> of; ///< whose image: a place among the layer's candidates, or past them
  std::vector<double> x, y, z;   ///< from the image to the particle that sees it
};

/// The particles that may see images behind a wall, or behind two or three where they meet, and those that
/// do, for the positions at the last sum of the densities (with a pair potential: of the forces). Kept so
/// that no step allocates. Who may come near, and near whose image, is looked for when the neighbour lists
/// were renewed or a wall has moved by a part of their skin.
struct WallLayer {
  std::vector<std::uint32_t> particles; ///< within the range of the walls
  std::vector<std::uint32_t> places;    ///< of each of them among the candidates
  std::vector<std::uint32_t> counts;    ///< and how many images it sees, its own among them
  WallImages images;

  std::vector<std::uint32_t> candidates;
  std::vector<std::uint32_t> near;  ///< whose images each candidate may see, in whole registers
  std::vector<std::size_t> begin;   ///< where those of each begin, and its images
  std::uint64_t renewal = 0;        ///< of the lists, and where the walls were, when they were found
  std::array<double, 3> position{}; ///< of the walls across x, y and z

  /// Calls f(j, r) for the images that the k-th particle sees: whose, and r from the image to the particle.
  template <class F>
  void for_each_image(std::size_t k, F const& f) const {
    auto const first = begin[places[k]];
    for (std::size_t m = first; m < first + counts[k]; ++m)
      f(candidates[images.of[m]], Vec3{images.x[m], images.y[m], images.z[m]});
  }
};

/// What makes a wall rough: friction towards its velocity, with the noise of its temperature (sdpd/README.md,
/// Eq. (S50)), or, without a bath, of the particles' own (Eq. (S57)). In the units of its owner.
struct WallFriction {
  bool acts = false;
  double temperature = 1; ///< of the wall, > 0
  double strength = 1;    ///< factor of the coefficients of friction, > 0
  Vec3 slide = {};        ///< velocity along the wall; its component along the normal is 0
  double slide_ramp = 0;  ///< time in which it comes to that velocity, >= 0
  bool bath = true;       ///< false: the wall is adiabatic, all heat of friction stays in the fluid

  Vec3 slide_at(double time) const {
    return time < slide_ramp ? std::max(0.0, time) / slide_ramp * slide : slide;
  }
};

/// A plane that mirrors the fluid (sdpd/README.md, Eq. (S40)): particles meet the images of themselves and of
/// each other, at the same density, pressure and temperature. Without friction it slips, and takes no heat.
/// In reduced units.
struct Wall {
  int axis = 0;             ///< 0, 1, 2: its normal is x, y, z
  bool upper = false;       ///< the fluid lies below it
  double start = 0;         ///< where it is as long as it has not moved
  std::uint32_t number = 0; ///< 0 and 1: the lower and the upper one; 2 ... 5: those of further axes
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
  double distance(Vec3 const& q, double time) const { return distance_from(position(time), q); }
  /// The same where the wall's place is known.
  double distance_from(double place, Vec3 const& q) const {
    double const x = component(q, axis) - place;
    return upper ? -x : x;
  }
};

/// Where two or three walls meet, particles see images of images (Eq. (S56)).
struct WallCorner {
  std::vector<std::size_t> walls; ///< their indices, one of each axis
  WallLayer layer = {};
};

} // namespace mesobridge::sdpd
