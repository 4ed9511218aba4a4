#pragma once
#include "workflows/lj/piston_file.hpp"

namespace mesobridge::workflows {

/// The mean pressure on a piston between the first and the last frame, in the units of the file, from the
/// energy that the fluid has gained and from its momentum (md/README.md, Eq. (M13)). They are one number
/// where nothing but the piston gives energy.
struct PistonBalance {
  double by_energy, by_momentum;
};

/// Of a melt, whose atoms have the mass 1; nothing for other files and fewer than two frames.
std::optional<PistonBalance> balance_of(PistonData const& data);

} // namespace mesobridge::workflows
