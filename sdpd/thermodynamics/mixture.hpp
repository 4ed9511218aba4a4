#pragma once
#include "sdpd/thermodynamics/thermodynamics.hpp"
#include <vector>

namespace mesobridge::sdpd {

/// Of particles of several species, each of which has its own: particle i that of its species.
std::unique_ptr<Thermodynamics const>
make_mixture(std::vector<std::unique_ptr<Thermodynamics const>> of_species);

} // namespace mesobridge::sdpd
