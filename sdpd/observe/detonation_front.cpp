#include "sdpd/observe/detonation_front.hpp"
#include "fitting/znd.hpp"
#include "sdpd/observe/frame_blocks.hpp"
#include <algorithm>
#include <limits>

namespace mesobridge::sdpd {
namespace {

constexpr double far_zone = 10, drawn_ahead = 10; // in spacings

/// The frames of a steady wave, and where their fronts are.
struct Taken {
  std::vector<DetonationFrame const*> frames;
  std::vector<double> fronts, times;
  std::vector<double> const& position;

  double width() const { return position[1] - position[0]; }

  /// A quantity of frame k at a distance from its front, between the centres of two slices; nothing outside,
  /// and beside slices without fluid, such as a piston leaves.
  std::optional<double> at(std::vector<double> const& values, std::size_t k, double depth) const {
    double const place = (fronts[k] + depth - position[0]) / width();
    if (place < 0 || place >= static_cast<double>(position.size() - 1))
      return std::nullopt;
    auto const s = static_cast<std::size_t>(place);
    auto const& rho = frames[k]->flow.rho;
    if (!(rho[s] > 0 && rho[s + 1] > 0))
      return std::nullopt;
    double const part = place - static_cast<double>(s);
    return (1 - part) * values[s] + part * values[s + 1];
  }

  double mean_progress(double depth, std::size_t first, std::size_t count) const {
    double sum = 0, seen = 0;
    for (std::size_t k = first; k < first + count; ++k)
      if (auto const value = at(frames[k]->progress, k, depth))
        sum += *value, ++seen;
    return seen > 0 ? sum / seen : std::numeric_limits<double>::quiet_NaN();
  }

  /// How far behind the front the mean progress reaches a share for the first time, seen from ahead; negative
  /// infinity where it does not.
  double depth_of(double share, std::size_t first, std::size_t count) const {
    double const step = width() / 4;
    double before = 0, last = fronts[first] - position.front();
    for (double depth = far_zone * width(); depth > -last; depth -= step) {
      double const now = mean_progress(depth, first, count);
      if (now >= share)
        return depth + step * (now - share) / (now - before);
      before = std::isnan(now) ? 0 : now;
    }
    return -std::numeric_limits<double>::infinity();
  }

  double zone(std::size_t first, std::size_t count) const {
    return depth_of(fitting::zone_begin, first, count) - depth_of(fitting::zone_end, first, count);
  }
};

/// With the spread of the frames as the error.
FrontProfile profile_of(Taken const& taken, double behind, double spacing) {
  FrontProfile profile;
  for (double depth = -behind; depth <= drawn_ahead * spacing; depth += taken.width()) {
    std::array<std::vector<double>, 5> seen;
    for (std::size_t k = 0; k < taken.frames.size(); ++k) {
      auto const& [flow, progress] = *taken.frames[k];
      std::size_t q = 0;
      for (auto const* values : {&flow.rho, &flow.P, &flow.T, &flow.velocity, &progress})
        if (auto const value = taken.at(*values, k, depth))
          seen[q++].push_back(*value);
    }
    if (seen[0].size() < 16)
      continue;
    profile.depth.push_back(depth);
    std::size_t q = 0;
    for (auto* to : {&profile.rho, &profile.P, &profile.T, &profile.velocity, &profile.progress})
      to->push_back(cg::estimate_mean(seen[q++]));
  }
  return profile;
}

} // namespace

std::optional<SteadyDetonation> steady_detonation(std::vector<DetonationFrame> const& frames,
                                                  ShockScale const& scale, double start) {
  SteadyDetonation found;
  Taken taken{{}, {}, {}, scale.position};
  for (std::size_t k = 0; k < frames.size(); ++k) {
    auto const& flow = frames[k].flow;
    auto const front = front_position(flow, scale);
    bool const at_the_end = front && *front > scale.position.back() - far_zone * scale.spacing;
    if (at_the_end && !taken.frames.empty())
      break; // what comes back from there is another wave
    if (!front || at_the_end || *front < flow.piston + start * (scale.position.back() - flow.piston))
      continue;
    found.frames.push_back(k);
    taken.frames.push_back(&frames[k]);
    taken.fronts.push_back(*front), taken.times.push_back(flow.time);
  }
  std::size_t const n = taken.frames.size(), half = n / 2;
  if (n < least_frames)
    return std::nullopt;
  auto const velocity = [&](std::size_t first, std::size_t count) {
    return slope_of(std::span(taken.times).subspan(first, count),
                    std::span(taken.fronts).subspan(first, count));
  };
  found.D = by_blocks(n, velocity);
  found.zone = by_blocks(n, [&](std::size_t first, std::size_t count) { return taken.zone(first, count); });
  if (!std::isfinite(found.zone.mean) || !std::isfinite(found.zone.se))
    return std::nullopt;
  // half of the blocks each: the error of the difference is twice that of the mean of all
  found.change_of_D = {velocity(half, n - half) - velocity(0, half), 2 * found.D.se, double{frame_blocks}};
  found.profile = profile_of(taken, std::max(2 * found.zone.mean, 80 * scale.spacing), scale.spacing);
  found.times = std::move(taken.times), found.fronts = std::move(taken.fronts);
  return found;
}

} // namespace mesobridge::sdpd
