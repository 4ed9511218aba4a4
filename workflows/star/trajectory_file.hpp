#pragma once
#include "md/box.hpp"
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace mesobridge::workflows {

/// One frame of a user's trajectory, atoms in the order of their ids; a molecule's atoms stand together.
struct TrajectoryFrame {
  std::int64_t step = 0;
  double time = 0;
  Box box;
  std::vector<Vec3> q, v;
};

/// Hands over the frames of a LAMMPS text dump (columns id, x y z or xu yu zu or xs ys zs, vx vy vz; `mol` if
/// molecules are not runs of consecutive ids) or of an H5MD file (group `all`). `time_step` turns steps into
/// times where the file has none. Molecules must be whole: `atoms_per_molecule` atoms each. Throws InputError
/// that names the file, the line and what is missing; atoms that belong to no whole molecule are an error.
void read_trajectory(std::filesystem::path const& file, std::size_t atoms_per_molecule, double time_step,
                     std::function<void(TrajectoryFrame const&)> const& consume);

} // namespace mesobridge::workflows
