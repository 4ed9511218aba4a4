#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd_fixtures.hpp"

namespace mesobridge::sdpd {

/// The DPD fluid of Groot and Warren, J. Chem. Phys. 107 (1997) 4423: a = 25, rho = 3, gamma = 4.5, k_BT = 1.
inline SimulationSettings dpd_fluid(double dt = 0.01) {
  return {.method =
              Dpd{{.mass = 1, .potential = SoftPotential(25, 1), .friction = PowerFriction(4.5, 0, 1, 2)}},
          .rho = 3,
          .T = 1,
          .lattice = {9, 9, 9},
          .disorder = 0.15,
          .dt = dt};
}

/// The same with internal energies of constant heat capacity C (in k_B) and with friction across the line of
/// centres too, if `across` says so.
inline SimulationSettings dpde_fluid(double C, double dt = 0.01, double across = 0) {
  auto s = dpd_fluid(dt);
  Dpde const method{
      {.mass = 1, .potential = SoftPotential(25, 1), .friction = PowerFriction(4.5, across, 1, 2)},
      fitting::ConstantHeatCapacity(C)};
  s.method = method;
  return s;
}

/// DPDE particles that conduct heat.
inline SimulationSettings with_pair_conduction(SimulationSettings settings, AnyWeightFunction const& weight) {
  settings.as<Dpde>().conduction = weight;
  return settings;
}

/// DPDE particles that exert no conservative force: an ideal gas with friction.
inline SimulationSettings dpde_ideal(double C, double dt, double across) {
  auto s = dpde_fluid(C, dt, across);
  s.as<Dpde>().potential = NoPotential{};
  return s;
}

struct NamedFluid {
  char const* name;
  SimulationSettings settings;
};

inline std::vector<NamedFluid> one_fluid_of_each_method() {
  return {{"sdpd", argon(100, 0.03)},
          {"reacting", burning_nitromethane(100, 0.02)},
          {"dpde", dpde_fluid(60)},
          {"dpd", dpd_fluid()}};
}

} // namespace mesobridge::sdpd
