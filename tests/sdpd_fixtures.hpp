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

/// Nitromethane that burns as in the thesis, section 6.3, with the heat of reaction of 4.78e-19 J a molecule;
/// it starts as compressed and hot as behind the front of its detonation.
inline SimulationSettings burning_nitromethane(double K, double dt, double progress = 0.3) {
  return {.method = Sdpd{.eos = fitting::material("nitromethane").eos,
                         .K = K,
                         .eta = 1e-2,
                         .reaction = SdpdReaction{.product = fitting::material("nitromethane-products").eos,
                                                  .heat = 4.7159e6,
                                                  .kinetics = SecondOrder{{1e15, 3e-19}, {}},
                                                  .progress = progress}},
          .rho = 1700,
          .T = 2500,
          .dt = dt};
}

inline SimulationSettings with_conduction(SimulationSettings settings, double kappa_reduced) {
  settings.as<Sdpd>().kappa = kappa_reduced * settings.units().conductivity();
  return settings;
}

} // namespace mesobridge::sdpd
