#include "sdpd/conservative/integrator.hpp"

namespace mesobridge::sdpd {

/// McLachlan's integrator (sdpd/README.md, Eq. (S29)), of two stages and the least error among such ones.
/// Symplectic and time-reversible, as Verlet is.
ConservativeIntegrator mclachlan_integrator() {
  return {
      .name = "mclachlan", .summary = "two evaluations, a far smaller energy error", .steps = [](double dt) {
        constexpr double outer = 0.1931833275037836;
        return std::vector{parts::kick_and_drift(outer * dt, dt / 2), parts::forces(),
                           parts::kick_and_drift((1 - 2 * outer) * dt, dt / 2), parts::forces(),
                           parts::kick(outer * dt)};
      }};
}

} // namespace mesobridge::sdpd
