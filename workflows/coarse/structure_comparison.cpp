#include "workflows/coarse/structure_comparison.hpp"
#include "md/error.hpp"
#include "sdpd/observe/radial_distribution.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t blocks_of_frames = 16;

} // namespace

RadialEstimate radial_estimate(cg::BlobSeries const& series, double width) {
  require(series.frames() >= blocks_of_frames, "frames", series.frames(),
          "at least 16 are needed for standard errors");
  auto const& box = series.boxes.front();
  for (auto const& other : series.boxes)
    require(other.is_that(box), "box", norm(other.edge), "must be the same in all frames");
  double const reach = 0.5 * box.narrowest();
  require(width > 0 && width < reach / 8, "bin width", width,
          fmt::format("must be above 0 and below {:g}", reach / 8));
  auto const bins = std::size_t(reach / width);
  RadialEstimate found{reach / double(bins), std::vector<cg::Estimate>(bins)};
  std::vector<double> sum(bins, 0.0), squares(bins, 0.0);
  for (auto const& [first, last] : cg::time_blocks(series.frames(), blocks_of_frames)) {
    sdpd::RadialDistribution block(box, reach, bins);
    for (std::size_t k = first; k < last; ++k)
      block.add({series.R.data() + k * series.molecules, series.molecules});
    auto const g = block.g();
    for (std::size_t bin = 0; bin < bins; ++bin)
      sum[bin] += g[bin], squares[bin] += g[bin] * g[bin];
  }
  double const n = blocks_of_frames;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    double const mean = sum[bin] / n, variance = std::max(0.0, squares[bin] / n - mean * mean);
    found.g[bin] = {mean, std::sqrt(variance / (n - 1)), n};
  }
  return found;
}

StructureDifference structure_difference(RadialEstimate const& ours, RadialEstimate const& of_reference) {
  require(std::abs(ours.width - of_reference.width) < 1e-3 * of_reference.width, "bin width", ours.width,
          fmt::format("must be that of the reference, {:g}", of_reference.width));
  StructureDifference found;
  double difference = 0, noise = 0, whole = 0;
  found.bins = std::min(ours.g.size(), of_reference.g.size());
  for (std::size_t bin = 0; bin < found.bins; ++bin) {
    auto const &a = ours.g[bin], &b = of_reference.g[bin];
    double const r = (double(bin) + 0.5) * ours.width, apart = a.mean - b.mean,
                 error2 = a.se * a.se + b.se * b.se;
    difference += apart * apart * r * r, noise += error2 * r * r, whole += b.mean * b.mean * r * r;
    found.largest = std::max(found.largest, std::abs(apart));
    if (error2 > 0)
      found.largest_in_se = std::max(found.largest_in_se, std::abs(apart) / std::sqrt(error2));
  }
  found.share = {std::sqrt(difference / whole), std::sqrt(noise / whole), double(blocks_of_frames)};
  return found;
}

} // namespace mesobridge::workflows
