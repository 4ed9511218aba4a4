#pragma once
#include "sdpd/kinetics/kind.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

/// A front that goes along z at a given speed, over whose width lambda rises to one:
/// lambda >= (start + D t - z)/width within [0, 1]. For controls: nothing asks whether the fluid would.
struct PrescribedBurn {
  static constexpr Parameter speed{"front_speed", Dimension::velocity, "D, at which the front goes along z",
                                   positive},
      start{"front_start", Dimension::length, "where it is at the start", any_number},
      width{"front_width", Dimension::length, "over which lambda rises from 0 to 1 behind it", positive};

  double D, z_0, w;

  static std::vector<KineticsKind<PrescribedBurn>> kinds() {
    return {{"prescribed", "a front of a given speed", {speed, start, width}, [](auto x) {
               return PrescribedBurn{x[0], x[1], x[2]};
             }}};
  }
  PrescribedBurn in_units(ReducedUnits const& units) const {
    return {D / units.velocity(), z_0 / units.length(), w / units.length()};
  }
  /// lambda at the place z and the time t of a particle that has got as far as `progress`.
  double progress(double progress, double z, double t) const {
    return std::max(progress, std::clamp((z_0 + D * t - z) / w, 0.0, 1.0));
  }
};

} // namespace mesobridge::sdpd
