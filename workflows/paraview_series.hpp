#pragma once
#include <filesystem>

namespace mesobridge::workflows {

/// Lets ParaView 5.11 open a trajectory, too. It reads VTKHDF of version 1, which knows no time: so each
/// frame of `trajectory.vtkhdf` gets a file of its own in `trajectory-frames/` beside it, which shows the
/// rows of that frame in the trajectory without holding them again, and `trajectory.hdf.series` lists these
/// files with their times (the form of ParaView's file series). What stood there before is replaced. Throws
/// InputError when the trajectory is no VTKHDF file, EnvironmentError.
void write_paraview_series(std::filesystem::path const& trajectory);

} // namespace mesobridge::workflows
