#pragma once
#include "fitting/internal_energy.hpp"
#include "sdpd/method/pair_fluid.hpp"
#include "sdpd/method/species.hpp"
#include <optional>

namespace mesobridge::sdpd {

/// Dissipative particle dynamics with energy conservation: what friction takes heats the particles.
struct Dpde : PairFluid {
  static constexpr std::string_view name = "dpde", title = "DPDE",
                                    help = "soft particles with internal energies";
  static constexpr Features features{.energies = true, .densities = false};

  fitting::AnyInternalEnergy internal_energy;
  /// kappa chi^2 of DpdeConduction, in energy times temperature over time, as the weight along the line of
  /// centres; without it particles exchange heat by friction alone.
  std::optional<AnyWeightFunction> conduction = {};
  /// Several species, whose masses and internal energies take the place of those above.
  std::vector<DpdeSpecies> species = {};

  double range(SimulationSettings const& at) const; ///< of the potential, the friction and the conduction
  bool conducts() const { return conduction.has_value(); }
  MethodParts parts(SimulationSettings const& at) const;
};

} // namespace mesobridge::sdpd
