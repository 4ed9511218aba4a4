#pragma once
#include "sdpd/method/pair_fluid.hpp"
#include "sdpd/method/species.hpp"

namespace mesobridge::sdpd {

/// Dissipative particle dynamics: friction and noise keep the set temperature.
struct Dpd : PairFluid {
  static constexpr std::string_view name = "dpd", title = "DPD", help = "soft particles at a set temperature";
  static constexpr Features features{.energies = false, .densities = false};

  std::vector<DpdSpecies> species = {}; ///< several, whose masses take the place of the one above

  bool conducts() const { return false; }
  MethodParts parts(SimulationSettings const& at) const { return parts_with<DpdLaw>(at); }
};

} // namespace mesobridge::sdpd
