#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"

namespace mesobridge::sdpd {

/// A step that would lead an internal energy out of the equation of state is not made.
PairIntegrator ams_integrator() {
  return {.name = "ams",
          .summary = "not made when an energy would leave the equation of state",
          .sweep = one_after_the_other<PairScheme::ams>,
          .of_heat = PairScheme::ams,
          .needs = {.internal_energies = "there is no step to reject"}};
}

} // namespace mesobridge::sdpd
