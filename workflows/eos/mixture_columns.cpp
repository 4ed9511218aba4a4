#include "workflows/eos/mixture_columns.hpp"
#include <cmath>

namespace mesobridge::workflows {

Columns mixture_columns(double rho, fitting::MixtureState const& state) {
  auto const c_2 = state.sound_speed_squared;
  return {{"rho", "_kg_m3", "kg/m^3", {rho}},
          {"T", "_K", "K", {state.T}},
          {"P", "_Pa", "Pa", {state.P}},
          {"e", "_J_kg", "J/kg", {state.e}},
          {"s", "_J_kg_K", "J/(kg K)", {state.s}},
          {"c_v", "_J_kg_K", "J/(kg K)", {state.c_v}},
          {"sound_speed", "_m_s", "m/s", {c_2 >= 0 ? std::optional(std::sqrt(c_2)) : std::nullopt}},
          {"rho_reactant", "_kg_m3", "kg/m^3", {state.rho_reactant}},
          {"rho_product", "_kg_m3", "kg/m^3", {state.rho_product}}};
}

} // namespace mesobridge::workflows
