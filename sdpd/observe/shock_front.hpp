#pragma once
#include "cg/estimate.hpp"
#include <optional>
#include <vector>

namespace mesobridge::sdpd {

/// Means over slices of equal width along the way of a shock, at one instant; in any one set of units.
struct ShockFrame {
  double time = 0, piston = 0; ///< since the piston began to move, and where it is
  std::vector<double> velocity, rho, P, T;
};

/// What a shock is looked at with: the slices' centres, the velocity of the piston, the mean distance between
/// particles.
struct ShockScale {
  std::vector<double> position;
  double v_P, spacing;
};

/// Where the velocity last falls through v_P/2, coming from the fluid at rest, between the centres of two
/// slices; nothing if the slice at the far end is that fast already or none is.
std::optional<double> front_position(ShockFrame const& frame, ShockScale const& scale);

/// A steady shock: the velocity of its front and the state behind it, each with its standard error.
struct SteadyShock {
  cg::Estimate v_S, rho, P, T;
  std::vector<std::size_t> frames;   ///< that were taken: their places in the list
  std::vector<double> times, fronts; ///< of these
  cg::Estimate v_S_gibbs;            ///< of Gibbs's surface in place of the half-height crossing
};

/// From the frames in which the front is further than 40 spacings from the piston, so that the start is left
/// behind, and than 10 from the far end. The state behind is the mean over the slices from 15 spacings before
/// the piston, where the start has left its trace, to 12 behind the front. The velocity is the slope of a
/// straight line of the last half-height crossing, and beside it that of Gibbs's surface (sdpd/README.md, Eq.
/// (S58)), whose states ahead and behind are those of the same frames. Neighbouring frames see the same
/// matter, so that their errors come from six blocks of frames, and those of the state from these or, where
/// they are larger, from the differences between parts of the matter behind the front, 5 spacings each, that
/// moves on with the piston. Frames whose plateau holds no slice are left out; nothing for fewer than 12.
std::optional<SteadyShock> steady_shock(std::vector<ShockFrame> const& frames, ShockScale const& scale);

} // namespace mesobridge::sdpd
