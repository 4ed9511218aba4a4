#include "fitting/fit_family.hpp"

namespace mesobridge::fitting {

/// Only the product Theta_0 u_r enters the model, and rho_0 only says where Gamma_0 and Theta_0 hold: u_r and
/// rho_0 stay fixed. So does Theta_0: u_r Theta_0 is the temperature at rho_0 of the isentrope that serves as
/// reference curve, and which one that is makes hardly a difference that data could tell; the default is the
/// isentrope of the coldest state. The bounds hold for metals, liquids and organic solids.
EosFamily mie_gruneisen_family(std::span<Observation const> data) {
  auto const d = summarise(data);
  return parametric_family<MieGruneisen>(
      {{"Gamma_0", "", "", "Gruneisen parameter at rho_0", 2, 0.1, 6},
       {"Gamma_inf", "", "", "its limit at high compression", 0.5, 0, 2},
       {"q", "", "", "how fast Gamma gets there", 1, 0.1, 8},
       {.name = "rho_0",
        .unit = "kg/m^3",
        .meaning = "where Gamma_0 and Theta_0 hold",
        .start = d.rho_start,
        .free = false},
       {.name = "Theta_0",
        .unit = "K",
        .meaning = "u_r Theta_0 is the temperature of the reference isentrope at rho_0",
        .start = d.T_min.value_or(300),
        .lower = 1,
        .upper = 1e4,
        .logarithmic = true,
        .free = false},
       {.name = "u_r", .meaning = "enters as Theta_0 u_r", .start = 1, .free = false},
       {"c_v", "", "J/(kg K)", "heat capacity", 500, 20, 1e4, true},
       {"rho_s", "", "kg/m^3", "density where the reference curve has no pressure", d.rho_start,
        0.7 * d.rho_start, 1.2 * d.rho_start},
       {"K_s", "", "Pa", "bulk modulus there", 5e10, 1e8, 2e12, true},
       {"N_s", "", "", "its pressure derivative", 4, 0.5, 20},
       {.name = "m0",
        .unit = "kg",
        .meaning = "mass of one atom; no data of these kinds tell it",
        .start = atomic_mass,
        .free = false}},
      d);
}

} // namespace mesobridge::fitting
