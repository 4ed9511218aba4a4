#include "fitting/eos/jwl.hpp"
#include "fitting/data_summary.hpp"

namespace mesobridge::fitting {

/// (D_CJ, P_CJ, T_CJ) set two constants, K and C_ek: one of the three is redundant. A different P_CJ only
/// names another state of the same Crussard curve, and at the true one, where the Rayleigh line touches that
/// curve, even D_CJ does not notice: P_CJ stays fixed (at the measured one, if there is). E_0 and
/// energy_offset shift C_ek too and stay fixed, E_0 at the energy of the detonation among the data, if there
/// is one; so does rho_0, the unit of density. R_1 and R_2 have bounds that do not overlap, or the two
/// exponentials could change places.
Description<JwlParameters> const& Jwl::description() {
  using P = JwlParameters;
  using Data = DataSummary;
  static Description<P> const description{
      .kind = "jwl",
      .material = "detonation products (Jones-Wilkins-Lee)",
      .example = "expansion.csv cj.csv --m0 \"61.04 u\" -o out/products.toml",
      .knows_energy_zero = true,
      .parameters =
          {{&P::Gamma_0, "Gamma_0", "", "Gruneisen parameter", positive, fitted(0.3, 0.05, 2)},
           {&P::rho_0, "rho_0", "kg/m^3", "density of the explosive, unit of the exponents", positive,
            fixed({1, &Data::rho_start})},
           {&P::E_0, "E_0", "J/kg", "energy of the explosive", any_number, fixed({1, &Data::e_explosive})},
           {&P::D_CJ, "D_CJ", "m/s", "detonation velocity: with P_CJ and T_CJ it sets K and C_ek", positive,
            fitted({1, &Data::D_CJ}, 1e3, 1.2e4)},
           {&P::P_CJ, "P_CJ", "Pa", "Chapman-Jouguet pressure", positive,
            fixed({1, &Data::P_CJ}, 1e9, 6e10).by_logarithm()},
           {&P::T_CJ, "T_CJ", "K", "Chapman-Jouguet temperature", positive, fitted(3000, 300, 1.2e4)},
           {&P::c_v, "c_v", "J/(kg K)", "heat capacity", positive, fitted(2000, 200, 1e4).by_logarithm()},
           {&P::a, "a", "Pa", "first exponential", any_number,
            fitted(3e11, 1e10, 1e13).by_logarithm().nearly_linear()},
           {&P::b, "b", "Pa", "second exponential", any_number,
            fitted(5e9, 1e8, 1e11).by_logarithm().nearly_linear()},
           {&P::R_1, "R_1", "", "its decay with rho_0/rho", positive, fitted(4.5, 3, 10)},
           {&P::R_2, "R_2", "", "its decay with rho_0/rho", positive, fitted(1.2, 0.3, 2.9)},
           {&P::m0, "m0", "kg", "mass of one molecule; no data of these kinds tell it", positive,
            fixed(atomic_mass)}},
      .materials = {{"nitromethane-products", "its detonation products, JWL (thesis, Table 6.3), SI",
                     nitromethane_products_parameters}}};
  return description;
}

Jwl::Jwl(JwlParameters const& parameters) : DescribedEos(parameters), log_rho_0_(std::log(p_.rho_0)) {
  double const impedance = p_.rho_0 * p_.D_CJ * p_.D_CJ;
  require(p_.P_CJ < impedance, "JWL P_CJ", p_.P_CJ, "must lie between 0 and rho_0 D_CJ^2");
  rho_CJ_ = p_.rho_0 * impedance / (impedance - p_.P_CJ);
  double const v = p_.rho_0 / rho_CJ_, A = p_.a * std::exp(-p_.R_1 * v), B = p_.b * std::exp(-p_.R_2 * v);
  double const E_CJ = p_.E_0 + 0.5 * p_.P_CJ * (1 / p_.rho_0 - 1 / rho_CJ_);
  double const rest = p_.P_CJ - A - B; // of the pressure: the K term and the thermal part
  K_ = (rest - p_.c_v * p_.Gamma_0 * p_.T_CJ * rho_CJ_) * std::pow(v, p_.Gamma_0 + 1);
  C_ek_ = E_CJ - (A / p_.R_1 + B / p_.R_2) / p_.rho_0 - rest / (rho_CJ_ * p_.Gamma_0);
}

std::string Jwl::edge() const {
  return fmt::format(
      "energies at or below the cold curve E_k(rho) are refused; K = {:.6g} Pa{}; in expansion the "
      "products become an ideal gas",
      K_,
      K_ < 0 ? " < 0 makes cold products mechanically unstable (no sound speed), at high density too" : "");
}

} // namespace mesobridge::fitting
