#pragma once
#include "cg/estimate.hpp"
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

namespace mesobridge::sdpd {

/// Neighbouring frames of a travelling wave see the same matter: errors come from so many blocks of them.
inline constexpr std::size_t frame_blocks = 6, least_frames = 2 * frame_blocks;

inline double mean_of(std::span<double const> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Of a straight line by least squares.
inline double slope_of(std::span<double const> x, std::span<double const> y) {
  double const x_0 = mean_of(x), y_0 = mean_of(y);
  double xy = 0, xx = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    xy += (x[k] - x_0) * (y[k] - y_0), xx += (x[k] - x_0) * (x[k] - x_0);
  return xy / xx;
}

/// The value of all frames with the error that the blocks' own values have; of_block(first, count) is the
/// value of some frames, of which there are at least as many as blocks.
template <class F>
cg::Estimate by_blocks(std::size_t frames, F const& of_block) {
  std::vector<double> values;
  std::size_t const length = frames / frame_blocks;
  for (std::size_t b = 0; b < frame_blocks; ++b)
    values.push_back(of_block(frames - (b + 1) * length, length));
  double const centre = mean_of(values);
  double square = 0;
  for (double const value : values)
    square += (value - centre) * (value - centre);
  return {of_block(0, frames), std::sqrt(square / (frame_blocks * (frame_blocks - 1))), double{frame_blocks}};
}

} // namespace mesobridge::sdpd
