#include "cg/transverse_currents.hpp"
#include "cg/own_motion.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace mesobridge::cg {
namespace {

constexpr double same_length = 1e-6; // of wave vectors of one shell, relative

/// The wave vector of which so many wave lengths lie along each edge of the box.
Vec3 vector_of(std::array<int, 3> const& waves, Box const& box) {
  double const turn = 2 * std::numbers::pi, x = turn * waves[0] / box.edge.x,
               y = (turn * waves[1] - box.xy * x) / box.edge.y;
  return {x, y, (turn * waves[2] - box.xz * x - box.yz * y) / box.edge.z};
}

/// Of k and -k, which tell the same, the one whose first number that is not 0 is positive.
bool is_first_of_pair(std::array<int, 3> const& waves) {
  return waves > std::array<int, 3>{0, 0, 0};
}

/// Two unit vectors perpendicular to k and to each other.
std::array<Vec3, 2> polarisations(Vec3 const& k) {
  Vec3 const along = k / norm(k);
  Vec3 const other = std::abs(along.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  Vec3 first = other - dot(other, along) * along;
  first = first / norm(first);
  return {first, cross(along, first)};
}

/// One wave vector, its polarisations, and where its series stand.
struct Wave {
  Vec3 k;
  std::array<Vec3, 2> across;
  Currents* currents;
  std::size_t first;
};

void require_one_box(BlobSeries const& series) {
  for (auto const& box : series.boxes)
    require(box.is_that(series.boxes.front()), "edges of the box", norm(box.edge),
            "must be the same in all frames for the waves that fit into it");
}

void add_frame(BlobSeries const& series, std::size_t frame, std::vector<Vec3> const& ways,
               std::vector<Vec3> const& velocities, std::vector<Wave> const& waves) {
  std::size_t const N = series.molecules;
  for (auto const& wave : waves) {
    std::array<std::complex<double>, 2> J{};
    for (std::size_t m = 0; m < N; ++m) {
      double const phase = dot(wave.k, series.R[m] + ways[frame * N + m]);
      std::complex<double> const turned{std::cos(phase), std::sin(phase)};
      for (std::size_t p = 0; p < 2; ++p)
        J[p] += series.mass * dot(wave.across[p], velocities[frame * N + m]) * turned;
    }
    for (std::size_t p = 0; p < 2; ++p) {
      (*wave.currents)[wave.first + 2 * p][frame] = J[p].real();
      (*wave.currents)[wave.first + 2 * p + 1][frame] = J[p].imag();
    }
  }
}

} // namespace

std::vector<WaveShell> wave_shells(Box const& box, double reach) {
  require(reach >= 1 && reach <= 6, "longest wave vector, in shortest ones", reach, "must be 1 ... 6");
  Vec3 const widths = box.widths();
  double const widest = std::max({widths.x, widths.y, widths.z}),
               longest =
                   std::max({box.edge.x, std::hypot(box.edge.y, box.xy), norm({box.xz, box.yz, box.edge.z})}),
               k_max = reach * 2 * std::numbers::pi / widest * (1 + same_length);
  std::vector<WaveShell> shells;
  int const most = int(reach * (longest / widest));
  for (int x = 0; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = -most; z <= most; ++z) {
        double const k = norm(vector_of({x, y, z}, box));
        if (!is_first_of_pair({x, y, z}) || k > k_max)
          continue;
        auto const at = std::ranges::find_if(
            shells, [&](WaveShell const& shell) { return std::abs(shell.k - k) < same_length * k; });
        (at == shells.end() ? shells.emplace_back(WaveShell{k, {}}) : *at).vectors.push_back({x, y, z});
      }
  std::ranges::sort(shells, {}, &WaveShell::k);
  return shells;
}

std::vector<Currents> transverse_currents(BlobSeries const& series, std::vector<WaveShell> const& shells) {
  require_one_box(series);
  auto const ways = own_ways(series), velocities = own_velocities(series);
  require_known_ways(series, ways);
  require_moving(velocities);
  std::vector<Currents> currents;
  std::vector<Wave> waves;
  for (auto const& shell : shells)
    currents.emplace_back(4 * shell.vectors.size(), std::vector<double>(series.frames()));
  for (std::size_t s = 0; s < shells.size(); ++s)
    for (std::size_t v = 0; v < shells[s].vectors.size(); ++v) {
      Vec3 const k = vector_of(shells[s].vectors[v], series.boxes.front());
      waves.push_back({k, polarisations(k), &currents[s], 4 * v});
    }
  for (std::size_t frame = 0; frame < series.frames(); ++frame)
    add_frame(series, frame, ways, velocities, waves);
  return currents;
}

} // namespace mesobridge::cg
