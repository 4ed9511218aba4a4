#include "sdpd/simulation.hpp"

namespace mesobridge::sdpd {

double SimulationSettings::spacing() const {
  return pair_fluid ? std::cbrt(pair_fluid->mass / rho) / units().length() : 1;
}

double SimulationSettings::range() const {
  return pair_fluid ? pair_fluid->range() / units().length() : h_factor;
}

bool SimulationSettings::conducts() const {
  return pair_fluid ? pair_fluid->conduction.has_value() : kappa > 0;
}

ReducedUnits SimulationSettings::units() const {
  if (pair_fluid)
    return pair_fluid->units(T);
  return std::visit(
      [this](auto const& model) {
        return ReducedUnits{.K = K,
                            .m0 = model.molecular_mass(),
                            .density = rho,
                            .temperature = T,
                            .boltzmann = model.boltzmann()};
      },
      eos);
}

} // namespace mesobridge::sdpd
