#include "fitting/eos/hz.hpp"
#include "fitting/data_summary.hpp"

namespace mesobridge::fitting {

/// T_0 and P_0 are the conditions at which the model has the density rho_0: they stay fixed.
Description<HzParameters> const& Hz::description() {
  using P = HzParameters;
  constexpr auto rho_start = &DataSummary::rho_start;
  static Description<P> const description{
      .kind = "hz",
      .material = "unreacted explosives (HZ)",
      .example = "workflows/data/nitromethane-us-up.csv --from nitromethane --fix Gamma_0=1 --fix c_v=1211 "
                 "-o out/nm.toml",
      .parameters = {{&P::Gamma_0, "Gamma_0", "", "Gruneisen parameter at rho_0", positive,
                      fitted(1, 0.05, 5)},
                     {&P::rho_0, "rho_0", "kg/m^3", "density at (T_0, P_0)", positive,
                      fitted({1, rho_start}, {0.8, rho_start}, {1.2, rho_start})},
                     {&P::c_0, "c_0", "m/s", "velocity of sound on the reference curve at rho_0", positive,
                      fitted(1500, 100, 1e4).by_logarithm()},
                     {&P::s, "s", "", "slope of v_S over v_P", not_negative, fitted(1.5, 0.2, 3.5)},
                     {&P::c_v, "c_v", "J/(kg K)", "heat capacity", positive,
                      fitted(1000, 20, 1e4).by_logarithm()},
                     {&P::T_0, "T_0", "K", "standard temperature", positive, fixed(298.13)},
                     {&P::P_0, "P_0", "Pa", "standard pressure", any_number, fixed(1e5)},
                     {&P::m0, "m0", "kg", "mass of one molecule; no data of these kinds tell it", positive,
                      fixed(atomic_mass)}},
      .materials = {
          {"nitromethane", "unreacted nitromethane, HZ (thesis, Table 6.2), SI", nitromethane_parameters}}};
  return description;
}

Hz::Hz(HzParameters const& p)
    : DescribedEos(p), theta_0_(p.T_0 - p.P_0 / (p.Gamma_0 * p.rho_0 * p.c_v)),
      rho_max_(p.s > 1 ? p.rho_0 * p.s / (p.s - 1) : std::numeric_limits<double>::infinity()) {
  require(theta_0_ > 0, "HZ T_0 - P_0/(Gamma_0 rho_0 c_v)", theta_0_, "must be > 0");
}

std::string Hz::edge() const {
  return fmt::format(
      "energies at or below that of T = 0 are refused; {}; below rho = {:.6g} the reference curve is "
      "in tension, and states colder than it turn mechanically unstable in expansion (no sound speed)",
      std::isfinite(rho_max_) ? fmt::format("towards rho = {:.6g} the reference pressure diverges", rho_max_)
                              : std::string("no compression is too high"),
      p_.rho_0);
}

} // namespace mesobridge::fitting
