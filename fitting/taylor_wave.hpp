#pragma once
#include "fitting/shock_relations.hpp"
#include <vector>

namespace mesobridge::fitting {

/// What follows a plane Chapman-Jouguet detonation that began at a wall: a rarefaction that grows with the
/// way of the front (G. I. Taylor, Proc. R. Soc. A 200 (1950) 235; fitting/README.md, Eq. (F26)).
struct TaylorPoint {
  double place; ///< z/(D t), 1 just behind the reaction zone
  double u;     ///< velocity of the fluid
  EosState state;
};

/// From the detonation down to the fluid that moves with the wall, which reaches from the last point to it;
/// the points are equidistant in density, `points` >= 2. `wall`: its velocity, below that of the products
/// behind the detonation, or no such wave follows (InputError). Throws PhysicsError where the products have
/// no state that moves so.
std::vector<TaylorPoint> taylor_wave(Fluid const& products, Shock const& chapman_jouguet, double wall,
                                     int points);

} // namespace mesobridge::fitting
