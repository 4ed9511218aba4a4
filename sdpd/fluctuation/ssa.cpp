#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"

namespace mesobridge::sdpd {

/// Every step of a pair is made. Throws PhysicsError when an internal energy leaves the equation of state.
PairIntegrator ssa_integrator() {
  return {.name = "ssa",
          .summary = "every step of a pair is made",
          .sweep = one_after_the_other<PairScheme::ssa>};
}

} // namespace mesobridge::sdpd
