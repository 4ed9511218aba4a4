#pragma once
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// What the files of a finished run will take on the disk, in bytes: run.h5 with samples, instants, profiles
/// and histograms; the trajectories; the checkpoint. Numbers are counted, headers are not (some kB each); of
/// extended XYZ, whose numbers are texts, the mean length of a number is taken.
struct DiskEstimate {
  double results = 0, trajectories = 0, checkpoint = 0;
  double total() const { return results + trajectories + checkpoint; }
};
DiskEstimate estimate_disk(Scene const& scene);

} // namespace mesobridge::workflows
