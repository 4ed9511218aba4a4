#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {

/// As many as the lists tell at the last evaluation of the densities or forces.
Measurement mean_neighbours() {
  return {.name = "mean_neighbours",
          .meaning = "of a particle, within the range of the interaction",
          .values = [](System const& system) -> std::vector<double> {
            return {2.0 * static_cast<double>(system.neighbours.pair_count()) /
                    static_cast<double>(system.size())};
          }};
}

} // namespace mesobridge::sdpd
