#pragma once
#include <filesystem>

namespace mesobridge::workflows {

/// The folder of the frames, beside the trajectory.
inline constexpr char const* paraview_frames = "trajectory-frames";

/// Lets ParaView 5.11 open a trajectory, too. It reads VTKHDF of version 1, which knows no time: so each frame of
/// `trajectory.vtkhdf` gets a file of its own in `trajectory-frames/` beside it, which shows the rows of that
/// frame in the trajectory without holding them again, and `trajectory.hdf.series` lists these files with their
/// times (the form of ParaView's file series). Frames that are there already stay: whoever begins another
/// trajectory removes those of the one before. Throws InputError when the trajectory is no VTKHDF file,
/// EnvironmentError.
void write_paraview_series(std::filesystem::path const& trajectory);

} // namespace mesobridge::workflows
