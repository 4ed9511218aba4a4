#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {

Measurement body_work() {
  return {.name = "body_work",
          .meaning = "work that the body force has done on the fluid so far",
          .dimension = Dimension::energy,
          .exists = [](Features const& has) { return has.body_force; },
          .values = [](System const& system) { return std::vector<double>{system.body_work}; }};
}

} // namespace mesobridge::sdpd
