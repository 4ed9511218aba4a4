#include "fitting/eos/mie_gruneisen.hpp"
#include "fitting/data_summary.hpp"

namespace mesobridge::fitting {

/// Only the product Theta_0 u_r enters the model, and rho_0 only says where Gamma_0 and Theta_0 hold: u_r and
/// rho_0 stay fixed. So does Theta_0: u_r Theta_0 is the temperature at rho_0 of the isentrope that serves as
/// reference curve, and which one that is makes hardly a difference that data could tell; the default is the
/// isentrope of the coldest state. The bounds hold for metals, liquids and organic solids.
Description<MieGruneisenParameters> const& MieGruneisen::description() {
  using P = MieGruneisenParameters;
  constexpr auto rho_start = &DataSummary::rho_start;
  constexpr NumberRange above_minus_1{.min = -1, .open = true};
  static Description<P> const description{
      .kind = "mie-gruneisen",
      .material = "metals and liquids under shock (Mie-Gruneisen)",
      .example = "workflows/data/tin-us-up.csv --m0 \"118.71 u\" --fix Gamma_0=2.3 --fix Gamma_inf=0 --fix "
                 "q=1 --fix c_v=210 -o out/tin.toml",
      .parameters =
          {{&P::Gamma_0, "Gamma_0", "", "Gruneisen parameter at rho_0", positive, fitted(2, 0.1, 6)},
           {&P::Gamma_inf, "Gamma_inf", "", "its limit at high compression", not_negative, fitted(0.5, 0, 2)},
           {&P::q, "q", "", "how fast Gamma gets there", positive, fitted(1, 0.1, 8)},
           {&P::rho_0, "rho_0", "kg/m^3", "where Gamma_0 and Theta_0 hold", positive, fixed({1, rho_start})},
           {&P::Theta_0, "Theta_0", "K", "u_r Theta_0 is the temperature of the reference isentrope at rho_0",
            positive, fixed({1, &DataSummary::T_coldest}, 1, 1e4).by_logarithm()},
           {&P::u_r, "u_r", "", "enters as Theta_0 u_r", positive, fixed(1)},
           {&P::c_v, "c_v", "J/(kg K)", "heat capacity", positive, fitted(500, 20, 1e4).by_logarithm()},
           {&P::rho_s, "rho_s", "kg/m^3", "density where the reference curve has no pressure", positive,
            fitted({1, rho_start}, {0.7, rho_start}, {1.2, rho_start})},
           {&P::K_s, "K_s", "Pa", "bulk modulus there", positive, fitted(5e10, 1e8, 2e12).by_logarithm()},
           {&P::N_s, "N_s", "", "its pressure derivative", above_minus_1, fitted(4, 0.5, 20)},
           {&P::m0, "m0", "kg", "mass of one atom; no data of these kinds tell it", positive,
            fixed(atomic_mass)}},
      .materials = {
          {"tin", "molten tin under shock, Mie-Gruneisen (thesis, Table 6.1), SI", tin_parameters}}};
  return description;
}

MieGruneisen::MieGruneisen(MieGruneisenParameters const& p)
    : DescribedEos(p), log_Theta_ur_(std::log(p.Theta_0 * p.u_r)) {}

std::string MieGruneisen::edge() const {
  return fmt::format(
      "energies at or below that of T = 0 are refused; in expansion the reference curve pulls with at "
      "most {:.4g} Pa while Gamma grows like rho^-{:.4g}: beyond the isothermal spinodal, where P(rho) "
      "at constant T has its minimum, P rises again and the model is neither liquid nor vapour; in "
      "compression the reference pressure stays below {:.4g} Pa",
      p_.K_s / (p_.N_s + 1), p_.q, p_.K_s * std::expm1(p_.N_s + 1) / (p_.N_s + 1));
}

} // namespace mesobridge::fitting
