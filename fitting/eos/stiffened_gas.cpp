#include "fitting/eos/stiffened_gas.hpp"
#include "fitting/data_summary.hpp"

namespace mesobridge::fitting {

/// Data do not tell q from energy_offset: q stays fixed. The molecules leave some of the densest volume free.
Description<StiffenedGasParameters> const& StiffenedGas::description() {
  using P = StiffenedGasParameters;
  constexpr auto v_min = &DataSummary::v_min;
  constexpr NumberRange above_1{.min = 1, .open = true};
  static Description<P> const description{
      .kind = "stiffened-gas",
      .material = "liquids (stiffened gas of Noble and Abel)",
      .example = "states.csv --m0 \"18.015 u\" -o out/liquid.toml",
      .parameters = {{&P::gamma, "gamma", "", "ratio of the heat capacities", above_1, fitted(1.5, 1.01, 8)},
                     {&P::P_inf, "P_inf", "Pa", "inner pressure", not_negative,
                      fitted(1e9, 1e6, 1e11).by_logarithm()},
                     {&P::c_v, "c_v", "J/(kg K)", "heat capacity", positive,
                      fitted(2000, 20, 1e4).by_logarithm()},
                     {&P::q, "q", "J/kg", "zero of the energy", any_number, fixed(0)},
                     {&P::m0, "m0", "kg", "mass of one molecule; no data of these kinds tell it", positive,
                      fixed(atomic_mass)},
                     {&P::b, "b", "m^3/kg", "volume of the molecules themselves", not_negative,
                      fitted({0.5, v_min}, 0, {0.95, v_min}), 0.0}},
      .materials = {
          {"water",
           "liquid water, 940 to 1170 kg/m^3 and 280 to 350 K (there its density is within 3 %), stiffened "
           "gas "
           "of Noble and Abel (Le Metayer and Saurel 2016), 0.1 MPa and 1500 m/s at 997 kg/m^3 and 300 K, SI",
           water_parameters, UsableRange{940, 1170, 280, 350}},
          {"air", "an ideal gas of exponent 1.4 and m0 = 28.96 u, SI", air_parameters}}};
  return description;
}

std::string StiffenedGas::edge() const {
  return fmt::format("energies at or below q + P_inf (1/rho - b) are refused; {}tension is possible "
                     "down to -{:.6g} Pa, and c^2 > 0 everywhere",
                     p_.b > 0 ? fmt::format("towards rho = {:.6g} the pressure diverges; ", 1 / p_.b)
                              : std::string(),
                     p_.P_inf);
}

} // namespace mesobridge::fitting
