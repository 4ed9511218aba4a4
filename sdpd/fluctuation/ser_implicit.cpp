#include "sdpd/fluctuation/fluctuation_implicit.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"

namespace mesobridge::sdpd {

PairIntegrator implicit_integrator() {
  return {.name = "ser-implicit",
          .summary = "all pairs at once, implicitly",
          .sweep = fluctuate_implicit,
          .of_heat = PairScheme::ams,
          .needs = {.internal_energies = "there are no temperatures for it to start from"}};
}

} // namespace mesobridge::sdpd
