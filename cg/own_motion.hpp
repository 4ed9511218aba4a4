#pragma once
#include "cg/blob_series.hpp"

namespace mesobridge::cg {

/// The way of each molecule from its first place, without the steps that all take together; number frame *
/// molecules + molecule. A step between two frames is the shortest that leads there in a periodic box.
std::vector<Vec3> own_ways(BlobSeries const& series);

/// Likewise the velocities.
std::vector<Vec3> own_velocities(BlobSeries const& series);

/// Throws InputError unless all frames are the same time apart, within 1e-6 of the interval.
void require_equal_intervals(BlobSeries const& series);

/// Throws InputError when a molecule takes a step of 0.4 edges of the box or more between two frames: where
/// none does, none has come more than half round the box.
void require_known_ways(BlobSeries const& series, std::vector<Vec3> const& ways);

/// Throws InputError when no molecule moves, as in files without velocities.
void require_moving(std::vector<Vec3> const& velocities);

} // namespace mesobridge::cg
