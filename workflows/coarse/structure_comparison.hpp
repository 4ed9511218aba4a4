#pragma once
#include "cg/blob_series.hpp"

namespace mesobridge::workflows {

/// A radial distribution with its standard errors.
struct RadialEstimate {
  double width = 0; ///< of a bin, from r = 0 on
  std::vector<cg::Estimate> g;
};

/// Of a series in one box, in bins of about `width` up to half of it; errors from the spread of 16 blocks of
/// frames. Throws InputError for fewer than 16 frames and for a bin width out of range.
RadialEstimate radial_estimate(cg::BlobSeries const& series, double width);

/// How far two distributions are apart.
struct StructureDifference {
  cg::Estimate
      share; ///< (int (g - g_0)^2 r^2 dr/int g_0^2 r^2 dr)^(1/2); its error is what noise alone makes it
  double largest = 0;       ///< |g - g_0|
  double largest_in_se = 0; ///< the largest of them in its own standard error
  std::size_t bins = 0;     ///< that were compared
};

/// Over the bins that both have. Throws InputError for bins of other widths.
StructureDifference structure_difference(RadialEstimate const& ours, RadialEstimate const& of_reference);

} // namespace mesobridge::workflows
