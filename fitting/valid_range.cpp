#include "fitting/valid_range.hpp"

namespace mesobridge::fitting {

std::optional<std::string> extrapolation(EosModel const& model, double rho, double T) {
  if (!model.valid)
    return std::nullopt;
  // The range of a Lennard-Jones model's data is reduced, the state in the model's own units.
  auto const* const lj = std::get_if<LjBwr>(&model.eos);
  double const density = lj ? lj->scale().density : 1, temperature = lj ? lj->scale().temperature : 1;
  double const rho_min = model.valid->rho_min * density, rho_max = model.valid->rho_max * density,
               T_min = model.valid->T_min * temperature, T_max = model.valid->T_max * temperature;
  if (rho >= rho_min && rho <= rho_max && T >= T_min && T <= T_max)
    return std::nullopt;
  return fmt::format(
      "the state (rho = {:.6g}, T = {:.6g}) lies outside the data of this model (rho from {:.4g} to "
      "{:.4g}, T from {:.4g} to {:.4g}): it is extrapolated",
      rho, T, rho_min, rho_max, T_min, T_max);
}

} // namespace mesobridge::fitting
