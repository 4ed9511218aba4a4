#include "cg/own_motion.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {

std::vector<Vec3> own_ways(BlobSeries const& series) {
  std::size_t const N = series.molecules;
  std::vector<Vec3> ways(series.R.size());
  for (std::size_t k = 1; k < series.frames(); ++k) {
    auto const& box = series.boxes[k];
    Vec3 together;
    for (std::size_t m = 0; m < N; ++m) {
      Vec3 const step = box.minimum_image(series.R[k * N + m] - series.R[(k - 1) * N + m]);
      ways[k * N + m] = step;
      together += step / double(N);
    }
    for (std::size_t m = 0; m < N; ++m)
      ways[k * N + m] += ways[(k - 1) * N + m] - together;
  }
  return ways;
}

std::vector<Vec3> own_velocities(BlobSeries const& series) {
  std::size_t const N = series.molecules;
  auto velocities = series.P;
  for (std::size_t k = 0; k < series.frames(); ++k) {
    Vec3 together;
    for (std::size_t m = 0; m < N; ++m)
      together += velocities[k * N + m] / double(N);
    for (std::size_t m = 0; m < N; ++m)
      velocities[k * N + m] = (velocities[k * N + m] - together) / series.mass;
  }
  return velocities;
}

void require_equal_intervals(BlobSeries const& series) {
  double const interval = series.interval();
  for (std::size_t k = 1; k < series.frames(); ++k)
    require(std::abs(series.times[k] - series.times[k - 1] - interval) < 1e-6 * interval,
            "interval of frames", series.times[k] - series.times[k - 1],
            fmt::format("must be {:g} everywhere", interval));
}

void require_known_ways(BlobSeries const& series, std::vector<Vec3> const& ways) {
  std::size_t const N = series.molecules;
  for (std::size_t k = 1; k < series.frames(); ++k)
    for (std::size_t m = 0; m < N; ++m) {
      Vec3 const step = series.boxes[k].parts(ways[k * N + m] - ways[(k - 1) * N + m]);
      double const share = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
      require(share < 0.4, "step of a molecule between two frames, in edges of the box", share,
              "must be below 0.4, or its way round the box is not known; write frames more often");
    }
}

void require_moving(std::vector<Vec3> const& velocities) {
  bool const moves = std::ranges::any_of(velocities, [](Vec3 const& v) { return norm2(v) > 0; });
  require(moves, "velocities of the molecules", 0, "must not all be zero: the file must hold velocities");
}

} // namespace mesobridge::cg
