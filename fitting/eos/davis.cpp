#include "fitting/eos/davis.hpp"
#include "fitting/data_summary.hpp"

namespace mesobridge::fitting {

/// The bounds hold the published sets of high explosives: PBX 9501 and 9502, HMX, TATB.
Description<DavisParameters> const& Davis::description() {
  using P = DavisParameters;
  constexpr NumberRange above_1{.min = 1, .open = true};
  static Description<P> const description{
      .kind = "davis",
      .material = "detonation products (Davis)",
      .example = "expansion.csv cj.csv --m0 \"258.15 u\" -o out/products.toml",
      .parameters =
          {{&P::a, "a", "", "half the rise of the adiabatic exponent in compression", positive,
            fitted(0.8, 0.2, 2)},
           {&P::b, "b", "", "part of that rise which Gamma does not follow", any_number, fitted(0.6, 0, 1)},
           {&P::k, "k", "", "adiabatic exponent of the thin products", above_1, fitted(1.3, 1.05, 1.7)},
           {&P::n, "n", "", "how suddenly the exponent rises", positive, fitted(2, 0.5, 6)},
           {&P::v_c, "v_c", "m^3/kg", "specific volume around which it does", positive,
            fitted(8e-4, 3e-4, 2e-3).by_logarithm()},
           {&P::p_c, "p_c", "Pa", "pressure there, but for a factor of about 1", positive,
            fitted(3.5e9, 3e8, 3e10).by_logarithm()},
           {&P::c_v, "c_v", "J/(kg K)", "heat capacity", positive, fitted(1000, 200, 1e4).by_logarithm()},
           {&P::m0, "m0", "kg", "mass of one molecule; no data of these kinds tell it", positive,
            fixed(atomic_mass)}},
      .materials = {
          {"pbx-9502-products",
           "detonation products of PBX 9502, Davis (Wescott, Stewart and Davis 2005), without their heat "
           "of detonation of 4.115e6 J/kg in the zero of energy, SI",
           pbx_9502_products_parameters}}};
  return description;
}

Davis::Davis(DavisParameters const& p)
    : DescribedEos(p), e_c_(p.p_c * p.v_c / (p.k - 1 + p.a)),
      log_T_c_(std::log(e_c_ / p.c_v) - p.a * p.b / p.n * std::log(2.0)) {
  double const dense = p.k - 1 + 2 * p.a * (1 - p.b);
  require(dense > 0, "Davis Gamma at high density, k - 1 + 2a (1 - b),", dense, "must be > 0");
}

std::string Davis::edge() const {
  return fmt::format("energies at or below that of T = 0 are refused; in expansion the products become an "
                     "ideal gas of exponent {:.6g}",
                     p_.k);
}

} // namespace mesobridge::fitting
