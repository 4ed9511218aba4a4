#pragma once
#include "cg/blob_series.hpp"
#include "cg/correlations.hpp"
#include "cg/entropy_routes.hpp"
#include "workflows/command.hpp"
#include "workflows/star/blob_file.hpp"

namespace mesobridge::workflows {

/// The columns of a file as the analyses take them.
cg::BlobSeries series_of(BlobData data);

/// The Lucy range of the thesis, h = 10 for 6-3 stars at rho = 0.3, at the same number of neighbours in any
/// melt.
double default_h(BlobFileHead const& head);

/// The frames between those whose pairs are looked at, an eighth of the energies' memory: nearer frames tell
/// little anew.
std::size_t default_pair_stride(cg::BlobSeries const& series);

Json correlations_json(cg::Correlations const& found);
std::string correlations_text(cg::Correlations const& found);

/// Files of blobs, what `md star-melt` and `md star-vacuum` wrote.
struct EntropyFiles {
  std::optional<BlobData> melt, vacuum, microcanonical;
  std::size_t order = 3;
};

/// Throws InputError when a file is not of its kind, PhysicsError as cg::fit_entropy.
cg::EntropyRoutes entropy_routes(EntropyFiles files);

Json entropy_json(cg::EntropyRoutes const& routes);
std::string entropy_text(cg::EntropyRoutes const& routes);

} // namespace mesobridge::workflows
