#pragma once
#include "sdpd/state/units.hpp"
#include "sdpd/state/wall.hpp"
#include <array>
#include <vector>

namespace mesobridge::sdpd {

/// What a face of the box is.
enum class FaceKind {
  periodic, ///< leads to the face on the other side, which is periodic too
  open,     ///< particles leave for vacuum
  wall      ///< a mirror, at rest or moving (Wall)
};

struct Face {
  FaceKind kind = FaceKind::periodic;
  WallMotion motion = {}; ///< of a wall
  WallFriction friction = {};
};

/// The lower and the upper face along x, y and z.
using Faces = std::array<std::array<Face, 2>, 3>;

/// Walls along one axis, both at rest if not told otherwise.
inline Faces walls_along(int axis, WallMotion const& lower = {}, WallMotion const& upper = {}) {
  Faces faces{};
  faces[static_cast<std::size_t>(axis)] = {Face{FaceKind::wall, lower}, Face{FaceKind::wall, upper}};
  return faces;
}

bool has_walls(Faces const& faces);

/// Whether a wall has friction.
bool has_rough_walls(Faces const& faces);

/// Which of the axes lead round.
std::array<bool, 3> periodic_axes(Faces const& faces);

/// Along which of them particles may leave the box.
std::array<bool, 3> open_axes(Faces const& faces);

/// The faces' walls in reduced units, of a box with these edges.
std::vector<Wall> make_walls(Faces const& faces, Vec3 const& edge, ReducedUnits const& units);

/// All edges and corners in which those walls meet.
std::vector<WallCorner> make_corners(std::vector<Wall> const& walls);

/// Throws InputError that names the face that cannot be as it is.
void check(Faces const& faces);

} // namespace mesobridge::sdpd
