#pragma once
#include "workflows/trajectory/trajectory_file.hpp"

namespace mesobridge::workflows {

/// As read_trajectory, of a LAMMPS text dump; frames in the order of the file.
void read_lammps_dump(std::filesystem::path const& file, TrajectoryReading const& how,
                      std::function<void(TrajectoryFrame const&)> const& consume);

} // namespace mesobridge::workflows
