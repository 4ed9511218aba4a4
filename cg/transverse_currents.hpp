#pragma once
#include "cg/blob_series.hpp"
#include <array>

namespace mesobridge::cg {

/// Wave vectors of a periodic box that have one length, one of each pair k, -k.
struct WaveShell {
  double k = 0;
  std::vector<std::array<int, 3>> vectors; ///< whole waves along the edges
};

/// The shells up to `reach` times the shortest wave vector of the box, shortest first. Throws InputError for
/// a reach below 1 or above 6.
std::vector<WaveShell> wave_shells(Box const& box, double reach);

/// The series of one shell's currents J = sum_m P_m,perp exp(i k R_m), cg/README.md, Eq. (C32): for each wave
/// vector two polarisations, of each the real and the imaginary part, as long as the run.
using Currents = std::vector<std::vector<double>>;

/// The currents of each shell in a box of one size; without the motion of all together. Throws InputError for
/// a box of another size in some frame, and as require_known_ways and require_moving.
std::vector<Currents> transverse_currents(BlobSeries const& series, std::vector<WaveShell> const& shells);

} // namespace mesobridge::cg
