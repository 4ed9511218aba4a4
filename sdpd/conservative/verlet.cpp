#include "sdpd/conservative/integrator.hpp"

namespace mesobridge::sdpd {

/// Velocity Verlet (sdpd/README.md, Eq. (S28)).
ConservativeIntegrator verlet_integrator() {
  return {.name = "verlet", .summary = "one evaluation of the forces a step", .steps = [](double dt) {
            return std::vector{parts::kick_and_drift(dt / 2, dt), parts::forces(), parts::kick(dt / 2)};
          }};
}

} // namespace mesobridge::sdpd
