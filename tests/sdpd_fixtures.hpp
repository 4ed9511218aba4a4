#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/simulation.hpp"

namespace mesobridge::sdpd {

/// The ideal gas of the thesis, section 4.1.3, with its kernel: m0 = 1e-25 kg, 1150 kg/m^3, 1000 K, eta =
/// 2e-3 Pa s.
inline SimulationSettings ideal_gas(double K, double dt) {
  return {.method = Sdpd{.eos = fitting::IdealGas(1e-25), .K = K, .kernel = "cubic", .eta = 2e-3},
          .rho = 1150,
          .T = 1000,
          .dt = dt};
}

/// The Lennard-Jones fluid of the thesis, section 5.1.2, at 1000 K and 1150 kg/m^3, with its kernel.
inline SimulationSettings argon(double K, double dt) {
  return {.method = Sdpd{.eos = fitting::material("argon").eos, .K = K, .kernel = "cubic", .eta = 2e-3},
          .rho = 1150,
          .T = 1000,
          .dt = dt};
}

inline SimulationSettings with_conduction(SimulationSettings settings, double kappa_reduced) {
  settings.as<Sdpd>().kappa = kappa_reduced * settings.units().conductivity();
  return settings;
}

} // namespace mesobridge::sdpd
