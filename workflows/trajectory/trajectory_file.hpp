#pragma once
#include "md/box.hpp"
#include "workflows/trajectory/unit_style.hpp"
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace mesobridge::workflows {

/// One frame of a user's trajectory, atoms in the order of their molecules and ids; a molecule's atoms stand
/// together. In the units of the mapping.
struct TrajectoryFrame {
  std::int64_t step = 0;
  std::optional<double> time{}; ///< as the file says it
  Box box;
  bool may_tilt = false; ///< the file says the box by three vectors, even if they are upright here
  std::array<bool, 3> periodic{true, true, true}; ///< false: a wall or open; nothing acts across it
  std::vector<Vec3> q, v;
  std::vector<Vec3> f{};                    ///< forces on the atoms; empty: the file has none
  std::optional<double> potential_energy{}; ///< of the whole system, as the file says it
  std::vector<std::int64_t> ids{};          ///< empty: the file has none

  /// A box whose periodic images are all that there are: along an axis that is not periodic it is so long
  /// that no image is within `reach` of an atom, nor nearer than the atom itself.
  Box image_box(double reach) const;
};

/// One atom of a system that is known.
struct ExpectedAtom {
  std::int64_t id = 0;
  int type = 0; ///< from 1
  double mass = 0;
};

/// How a trajectory is to be taken, and what it gave.
struct TrajectoryReading {
  std::size_t atoms_per_molecule = 1;
  /// All atoms that a frame must have, in the order in which they are wanted; empty: equal molecules.
  std::vector<ExpectedAtom> atoms{};
  std::vector<double> masses{}; ///< of a molecule's atoms, to compare with a dump's column `mass`
  UnitStyle units{};            ///< of the mapping
  bool units_given = false;     ///< by the mapping; otherwise they are the default
  std::string group{};          ///< of an H5MD file's particles; empty: the only one
  std::function<void(std::string const&)> warn = [](std::string const&) {};
};

/// Hands over the frames of a LAMMPS text dump (columns id, x y z or xu yu zu or xs ys zs or xsu ysu zsu, vx
/// vy vz; fx fy fz if forces are wanted; `mol` if molecules are not runs of consecutive ids; others are not
/// needed) or of an H5MD file (position, velocity and box/edges of one group of particles, each with its own
/// steps: the frames that have all of them). What the file says about units, times, boundaries and ids is
/// taken; a tilted box is turned so that its first edge lies along x and its second in the plane of x and y,
/// and all vectors with it; a step that stands there once more is left out, with a warning, as is a last
/// frame that is not whole.
///
/// Throws InputError that names the file, the line or the element, and what is missing: values
/// that are not finite, steps that decrease, units that contradict the mapping's, atoms of no whole molecule.
void read_trajectory(std::filesystem::path const& file, TrajectoryReading const& how,
                     std::function<void(TrajectoryFrame const&)> const& consume);

} // namespace mesobridge::workflows
