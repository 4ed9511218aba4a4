#pragma once
#include "workflows/trajectory/trajectory_file.hpp"

namespace mesobridge::workflows {

/// As read_trajectory, of an H5MD file; frames in the order of the positions.
void read_h5md_trajectory(std::filesystem::path const& file, TrajectoryReading const& how,
                          std::function<void(TrajectoryFrame const&)> const& consume);

} // namespace mesobridge::workflows
