#pragma once
#include "cg/blob_series.hpp"
#include "sdpd/simulation.hpp"

namespace mesobridge::sdpd {

/// The particles' motion from here on as that of blobs, in reduced units: so many frames, `between` steps of
/// `dt` apart.
inline cg::BlobSeries motion_from_here(Simulation& simulation, int frames, std::uint64_t between, double dt) {
  cg::BlobSeries series{.molecules = simulation.size(), .atoms = 1, .mass = 1};
  for (int frame = 0; frame < frames; ++frame) {
    simulation.advance(between);
    auto const now = simulation.snapshot();
    series.times.push_back(dt * double(between) * frame), series.boxes.push_back(simulation.box());
    series.R.insert(series.R.end(), now.q.begin(), now.q.end());
    series.P.insert(series.P.end(), now.p.begin(), now.p.end());
  }
  return series;
}

} // namespace mesobridge::sdpd
