#include "workflows/coarse/structure_of_blobs.hpp"
#include "md/error.hpp"
#include "sdpd/observe/radial_distribution.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t most_frames_seen = 400; // neighbouring ones show the same structure

} // namespace

double kT_of(BlobData const& data) {
  auto const N = std::size_t(data.head.molecules);
  double sum = 0;
  for (std::size_t k = 0; k < data.frames(); ++k) {
    Vec3 together;
    for (std::size_t m = 0; m < N; ++m)
      together += data.P[k * N + m] / double(N);
    for (std::size_t m = 0; m < N; ++m)
      sum += norm2(data.P[k * N + m] - together);
  }
  require(sum > 0 && N > 1, "motion of the molecules", sum, "they must move, or they have no temperature");
  double const frames = double(data.frames()), of_centres = sum / data.head.mass;
  if (data.head.T == 0) // a trajectory, whose atoms may be held together by constraints
    return of_centres / (3 * double(N - 1) * frames);
  double const inside = 2 * std::accumulate(data.U_kin.begin(), data.U_kin.end(), 0.0);
  return (of_centres + inside) / (3 * (double(N) * data.head.atoms - 1) * frames);
}

CoarseStructure structure_of(BlobFileHead const& head, std::vector<Box> const& boxes,
                             std::vector<Vec3> const& R, double kT, double width) {
  auto const N = std::size_t(head.molecules);
  require(head.rho > 0, "blobs", head.kind, "must be those of a melt or a trajectory");
  require(N >= 8 && !boxes.empty(), "molecules", N, "at least 8 are needed for a structure");
  auto const& box = boxes.front();
  double const reach = 0.5 * box.narrowest();
  require(width > 0 && width < reach / 8, "bin width", width,
          fmt::format("must be above 0 and below {:g}", reach / 8));
  for (auto const& other : boxes)
    require(other.is_that(box), "box", norm(other.edge), "must be the same in all frames");
  auto const bins = std::size_t(reach / width);
  sdpd::RadialDistribution found(box, reach, bins);
  std::size_t const stride = std::max<std::size_t>(1, boxes.size() / most_frames_seen);
  for (std::size_t k = 0; k < boxes.size(); k += stride)
    found.add({R.data() + k * N, N});
  return {.density = double(N) / box.volume(),
          .mass = head.mass,
          .kT = kT,
          .g = {reach / double(bins), found.g()}};
}

CoarseStructure structure_of(BlobData const& data, double width) {
  auto structure = structure_of(data.head, data.boxes, data.R, kT_of(data), width);
  // Trajectories say no pressure, and their blobs have 0 in its place.
  if (std::ranges::any_of(data.pressures, [](double P) { return P != 0; }))
    structure.P =
        std::accumulate(data.pressures.begin(), data.pressures.end(), 0.0) / double(data.pressures.size());
  return structure;
}

double usual_cutoff(cg::RadialBins const& bins, bool at_pressure) {
  std::size_t last = bins.g.size();
  while (last > 8 && std::abs(bins.g[last - 1] - 1) < 0.02)
    --last;
  last = std::min(at_pressure ? last * 13 / 10 : last, bins.g.size() * 4 / 5);
  return double(last) * bins.width;
}

} // namespace mesobridge::workflows
