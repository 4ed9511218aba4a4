#pragma once
#include "sdpd/observe/shock_front.hpp"

namespace mesobridge::sdpd {

/// Means over slices of equal width along the way of a detonation towards larger coordinates, at one instant;
/// in any one set of units.
struct DetonationFrame {
  ShockFrame flow; ///< `piston` is where the wave began
  std::vector<double> progress;
};

/// A mean over frames at a distance from the front, < 0 behind it.
struct FrontProfile {
  std::vector<double> depth;
  std::vector<cg::Estimate> rho, P, T, velocity, progress;
};

/// A detonation that has become steady: the velocity of its front, the length of the zone in which the mean
/// progress lies between the two shares, and how the velocity changes from the first half of the frames to
/// the second, each with its standard error.
struct SteadyDetonation {
  cg::Estimate D, zone, change_of_D;
  std::vector<std::size_t> frames;   ///< that were taken: their places in the list
  std::vector<double> times, fronts; ///< of these
  FrontProfile profile;
};

/// From the frames in which the front has left the first `start` of the way between its beginning and the far
/// end behind (a share from 0 to 1), up to where it comes within 10 spacings of the far end. The front is the
/// last crossing of half the velocity of the scale; errors come from six blocks of frames. The zone ends
/// where the mean progress over the frames, at equal distances from the front, has come to zone_begin and
/// zone_end for the first time behind it; its error is that of the blocks. Nothing for fewer than 12 such
/// frames, or where no frame shows the whole zone.
std::optional<SteadyDetonation> steady_detonation(std::vector<DetonationFrame> const& frames,
                                                  ShockScale const& scale, double start);

} // namespace mesobridge::sdpd
