#pragma once
#include "cg/correlations.hpp"

namespace mesobridge::cg {

/// Fills in how energies depend on the local density, with errors over these blocks of frames. `W` is the
/// configurational energy of each blob, `densities` the local ones of every frame whose pairs were looked at:
/// number (frame/stride) * molecules + molecule.
void density_results_into(BlobSeries const& series, std::vector<double> const& W,
                          std::vector<double> const& densities, CorrelationSettings const& settings,
                          std::vector<std::pair<std::size_t, std::size_t>> const& blocks, Correlations& out);

} // namespace mesobridge::cg
