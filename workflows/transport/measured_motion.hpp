#pragma once
#include "cg/blob_series.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// How molecules or particles have moved, from a file of blobs or from the folder of a run.
struct MeasuredMotion {
  cg::BlobSeries series;
  std::string name;             ///< of what moves, "6-3"
  std::string units;            ///< for people
  double boltzmann = 1;         ///< in these units: k_B T over it is a temperature
  std::filesystem::path file;   ///< what was read
  std::filesystem::path folder; ///< where results belong
};

/// Of a file that `md star-melt` or `cg blobs` wrote, or of a folder that `run` wrote with
/// `run.trajectory_every`: its trajectory in the scene's units, SI or reduced. Throws InputError for walls,
/// isolated molecules, times that are numbers of steps, particles of several masses, a run without
/// trajectory.
MeasuredMotion read_motion(std::filesystem::path const& input, Context const& context);

} // namespace mesobridge::workflows
