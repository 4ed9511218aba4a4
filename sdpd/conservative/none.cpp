#include "sdpd/conservative/integrator.hpp"

namespace mesobridge::sdpd {

/// Particles stay where they are, for studies of fluctuation and dissipation.
ConservativeIntegrator no_integrator() {
  return {.name = "none",
          .summary = "particles stay in place, fluctuation and dissipation alone",
          .steps = [](double) { return std::vector<SubStep>{}; }};
}

} // namespace mesobridge::sdpd
