#include "fitting/fit_family.hpp"

namespace mesobridge::fitting {

/// T_0 and P_0 are the conditions at which the model has the density rho_0: they stay fixed.
EosFamily hz_family(std::span<Observation const> data) {
  auto const d = summarise(data);
  return parametric_family<Hz>(
      {{"Gamma_0", "", "", "Gruneisen parameter at rho_0", 1, 0.05, 5},
       {"rho_0", "", "kg/m^3", "density at (T_0, P_0)", d.rho_start, 0.8 * d.rho_start, 1.2 * d.rho_start},
       {"c_0", "", "m/s", "velocity of sound on the reference curve at rho_0", 1500, 100, 1e4, true},
       {"s", "", "", "slope of v_S over v_P", 1.5, 0.2, 3.5},
       {"c_v", "", "J/(kg K)", "heat capacity", 1000, 20, 1e4, true},
       {.name = "T_0", .unit = "K", .meaning = "standard temperature", .start = 298.13, .free = false},
       {.name = "P_0", .unit = "Pa", .meaning = "standard pressure", .start = 1e5, .free = false},
       {.name = "m0",
        .unit = "kg",
        .meaning = "mass of one molecule; no data of these kinds tell it",
        .start = atomic_mass,
        .free = false}},
      d);
}

} // namespace mesobridge::fitting
