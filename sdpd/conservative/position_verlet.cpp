#include "sdpd/conservative/integrator.hpp"

namespace mesobridge::sdpd {

/// Position Verlet: q += p/m dt/2, p += f dt, q += p/m dt/2 (Tuckerman, Berne and Martyna, J. Chem. Phys. 97
/// (1992) 1990). Symplectic and time-reversible. The forces are found once more at the end, where they are
/// asked for.
ConservativeIntegrator position_verlet_integrator() {
  return {.name = "position-verlet",
          .summary = "drift, kick, drift; two evaluations of the forces a step",
          .steps = [](double dt) {
            constexpr double no_kick = 0;
            return std::vector{parts::kick_and_drift(no_kick, dt / 2), parts::forces(),
                               parts::kick_and_drift(dt, dt / 2), parts::forces()};
          }};
}

} // namespace mesobridge::sdpd
