#pragma once
#include "fitting/shock_relations.hpp"
#include <vector>

namespace mesobridge::fitting {

/// What follows a plane Chapman-Jouguet detonation that began at a wall at rest: a rarefaction that grows
/// with the way of the front (G. I. Taylor, Proc. R. Soc. A 200 (1950) 235; fitting/README.md, Eq. (F26)).
struct TaylorPoint {
  double place; ///< z/(D t), 1 just behind the reaction zone
  double u;     ///< velocity in the frame of the wall
  EosState state;
};

/// From the detonation down to the fluid at rest, which reaches from the last point to the wall; the points
/// are equidistant in density, `points` >= 2. Throws PhysicsError where the products have no state at rest.
std::vector<TaylorPoint> taylor_wave(Fluid const& products, Shock const& chapman_jouguet, int points);

} // namespace mesobridge::fitting
