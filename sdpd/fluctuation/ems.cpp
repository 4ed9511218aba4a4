#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"

namespace mesobridge::sdpd {

/// As AMS, and a Metropolis test makes the invariant measure exact at any dt (sdpd/README.md, Eq. (S24)).
PairIntegrator ems_integrator() {
  return {.name = "ems",
          .summary = "put to a Metropolis test too, which makes it exact at any time step",
          .sweep = one_after_the_other<PairScheme::ems>,
          .noise = {fluctuation_noise, acceptance_noise},
          .of_heat = PairScheme::ems,
          .needs = {.noise = "there is nothing to put to a Metropolis test",
                    .internal_energies = "there is no step to reject"}};
}

} // namespace mesobridge::sdpd
