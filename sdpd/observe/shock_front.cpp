#include "sdpd/observe/shock_front.hpp"
#include "sdpd/observe/frame_blocks.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

constexpr double start_zone = 40, far_zone = 10, piston_zone = 15, front_zone = 12; // in spacings
constexpr double part_width = 5; ///< in spacings: as wide as the usual kernels

/// A slice of the plateau behind the front.
struct PlateauSlice {
  std::size_t slice;
  double depth; ///< from the plateau's beginning before the piston, in spacings
};

/// None where the slices are so wide that the plateau holds no centre of one.
std::vector<PlateauSlice> plateau_of(ShockFrame const& frame, ShockScale const& scale, double front) {
  std::vector<PlateauSlice> slices;
  for (std::size_t s = 0; s < scale.position.size(); ++s) {
    double const depth = (scale.position[s] - frame.piston) / scale.spacing - piston_zone;
    if (depth > 0 && scale.position[s] < front - front_zone * scale.spacing)
      slices.push_back({s, depth});
  }
  return slices;
}

/// A quantity behind the front: the means over the plateau of each frame, and sums over the frames for parts
/// of the matter in it, which move on with the piston.
class Plateau {
 public:
  /// One frame's values over its slices.
  void add(std::vector<double> const& values, std::vector<PlateauSlice> const& slices) {
    double sum = 0;
    for (auto const& [s, depth] : slices) {
      sum += values[s];
      auto const part = static_cast<std::size_t>(depth / part_width);
      if (parts_.size() <= part)
        parts_.resize(part + 1);
      parts_[part].sum += values[s], ++parts_[part].count;
    }
    means_.push_back(sum / static_cast<double>(slices.size()));
  }

  /// Of the frames.
  std::span<double const> means() const { return means_; }

  /// With the larger of two errors: of blocks of frames, and of the parts of the matter, which hardly changes
  /// from frame to frame.
  cg::Estimate estimate() const {
    auto found = by_blocks(means_.size(), [&](std::size_t first, std::size_t count) {
      return mean_of(std::span(means_).subspan(first, count));
    });
    found.se = std::max(found.se, error_of_parts());
    return found;
  }

 private:
  struct Part {
    double sum = 0, count = 0;
  };

  /// Of their mean, weighted with what has been seen of each; 0 for fewer than three.
  double error_of_parts() const {
    double sum = 0, count = 0, square = 0, seen = 0;
    for (auto const& part : parts_)
      sum += part.sum, count += part.count;
    for (auto const& part : parts_)
      if (part.count > 0) {
        double const off = part.sum - part.count * sum / count;
        square += off * off, ++seen;
      }
    return seen < 3 ? 0 : std::sqrt(square * seen / (seen - 1)) / count;
  }

  std::vector<double> means_;
  std::vector<Part> parts_;
};

constexpr double ahead_zone = 8; // in spacings, as far as the front is from the far end at least

/// What Gibbs's surface is found from, of each frame: where the piston is, how much fluid and room there is
/// before it, and the density ahead of the front.
struct Masses {
  std::vector<double> piston, mass, length, ahead;

  void add(ShockFrame const& frame, ShockScale const& scale, double front) {
    double const width = scale.position[1] - scale.position[0];
    double fluid = 0, sum = 0, count = 0;
    for (std::size_t s = 0; s < frame.rho.size(); ++s) {
      double const before_piston = std::clamp(scale.position[s] + width / 2 - frame.piston, 0.0, width);
      fluid += frame.rho[s] * before_piston;
      if (scale.position[s] > front + ahead_zone * scale.spacing)
        sum += frame.rho[s], ++count;
    }
    piston.push_back(frame.piston), mass.push_back(fluid);
    length.push_back(scale.position.back() + width / 2 - frame.piston);
    ahead.push_back(count > 0 ? sum / count : frame.rho.back());
  }

  /// The places of the surface in some frames that have the density rho_1 behind the front.
  std::vector<double> surfaces(std::size_t first, std::size_t count, double rho_1) const {
    double const rho_0 = mean_of(std::span(ahead).subspan(first, count));
    std::vector<double> places;
    for (std::size_t k = first; k < first + count; ++k)
      places.push_back(piston[k] + (mass[k] - rho_0 * length[k]) / (rho_1 - rho_0));
    return places;
  }
};

} // namespace

std::optional<double> front_position(ShockFrame const& frame, ShockScale const& scale) {
  auto const& v = frame.velocity;
  double const half = scale.v_P / 2;
  if (v.empty() || v.back() > half)
    return std::nullopt;
  for (std::size_t s = v.size() - 1; s > 0; --s)
    if (v[s - 1] > half) {
      double const width = scale.position[s] - scale.position[s - 1];
      return scale.position[s] - width * (half - v[s]) / (v[s - 1] - v[s]);
    }
  return std::nullopt;
}

std::optional<SteadyShock> steady_shock(std::vector<ShockFrame> const& frames, ShockScale const& scale) {
  SteadyShock shock;
  Plateau rho, P, T;
  Masses masses;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    auto const front = front_position(frames[k], scale);
    bool const at_the_end = front && *front > scale.position.back() - far_zone * scale.spacing;
    if (at_the_end && !shock.frames.empty())
      break; // what comes back from there is another wave
    if (!front || at_the_end || *front < frames[k].piston + start_zone * scale.spacing)
      continue;
    auto const plateau = plateau_of(frames[k], scale, *front);
    if (plateau.empty())
      continue;
    shock.frames.push_back(k), shock.times.push_back(frames[k].time), shock.fronts.push_back(*front);
    masses.add(frames[k], scale, *front);
    for (auto const& [to, from] : {std::pair(&rho, &frames[k].rho), {&P, &frames[k].P}, {&T, &frames[k].T}})
      to->add(*from, plateau);
  }
  if (shock.times.size() < least_frames)
    return std::nullopt;
  auto const part = [](std::vector<double> const& of, std::size_t first, std::size_t count) {
    return std::span(of).subspan(first, count);
  };
  std::size_t const n = shock.times.size();
  shock.v_S = by_blocks(n, [&](std::size_t first, std::size_t count) {
    return slope_of(part(shock.times, first, count), part(shock.fronts, first, count));
  });
  shock.v_S_gibbs = by_blocks(n, [&](std::size_t first, std::size_t count) {
    return slope_of(part(shock.times, first, count),
                    masses.surfaces(first, count, mean_of(rho.means().subspan(first, count))));
  });
  shock.rho = rho.estimate(), shock.P = P.estimate(), shock.T = T.estimate();
  return shock;
}

} // namespace mesobridge::sdpd
