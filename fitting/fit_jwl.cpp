#include "fitting/fit_family.hpp"

namespace mesobridge::fitting {

/// (D_CJ, P_CJ, T_CJ) set two constants, K and C_ek: one of the three is redundant. A different P_CJ only
/// names another state of the same Crussard curve, and at the true one, where the Rayleigh line touches that
/// curve, even D_CJ does not notice: P_CJ stays fixed (at the measured one, if there is). E_0 and
/// energy_offset shift C_ek too and stay fixed, E_0 at the energy of the detonation among the data, if there
/// is one; so does rho_0, the unit of density. R_1 and R_2 have bounds that do not overlap, or the two
/// exponentials could change places.
EosFamily jwl_family(std::span<Observation const> data) {
  auto const d = summarise(data);
  double D = 7000, P = 2e10, E = 0;
  for (auto const& observation : data)
    if (observation.path == DataPath::cj) {
      E = observation.start.value().e.value_or(0);
      for (auto const& datum : observation.measured) {
        if (datum.quantity == Quantity::v_S)
          D = datum.value;
        if (datum.quantity == Quantity::P)
          P = datum.value;
      }
    }
  auto family = parametric_family<Jwl>(
      {{"Gamma_0", "", "", "Gruneisen parameter", 0.3, 0.05, 2},
       {.name = "rho_0",
        .unit = "kg/m^3",
        .meaning = "density of the explosive, unit of the exponents",
        .start = d.rho_start,
        .free = false},
       {.name = "E_0", .unit = "J/kg", .meaning = "energy of the explosive", .start = E, .free = false},
       {"D_CJ", "", "m/s", "detonation velocity: with P_CJ and T_CJ it sets K and C_ek", D, 1e3, 1.2e4},
       {.name = "P_CJ",
        .unit = "Pa",
        .meaning = "Chapman-Jouguet pressure",
        .start = P,
        .lower = 1e9,
        .upper = 6e10,
        .logarithmic = true,
        .free = false},
       {"T_CJ", "", "K", "Chapman-Jouguet temperature", 3000, 300, 1.2e4},
       {"c_v", "", "J/(kg K)", "heat capacity", 2000, 200, 1e4, true},
       {"a", "", "Pa", "first exponential", 3e11, 1e10, 1e13, true, true, true},
       {"b", "", "Pa", "second exponential", 5e9, 1e8, 1e11, true, true, true},
       {"R_1", "", "", "its decay with rho_0/rho", 4.5, 3, 10},
       {"R_2", "", "", "its decay with rho_0/rho", 1.2, 0.3, 2.9},
       {.name = "m0",
        .unit = "kg",
        .meaning = "mass of one molecule; no data of these kinds tell it",
        .start = atomic_mass,
        .free = false}},
      d);
  family.parameters.back().free = false;
  return family;
}

} // namespace mesobridge::fitting
