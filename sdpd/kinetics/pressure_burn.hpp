#pragma once
#include "sdpd/kinetics/kind.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::sdpd {

/// Ignition by compression and growth by pressure (sdpd/README.md, Eq. (S63)):
///   d lambda/dt = I (1 - lambda)^b (rho/rho_0 - 1 - a)^x + G (1 - lambda)^c lambda^d (P/P_ref)^y,
/// each term where its base is positive; rho_0 is the fluid's mean density.
struct PressureBurn {
  static constexpr NumberRange powers{.min = 0, .max = 100};
  static constexpr Parameter ignition{"ignition", Dimension::rate, "I, the rate of ignition", not_negative},
      threshold{"ignition_compression", std::nullopt, "a, the compression rho/rho_0 - 1 where it begins",
                not_negative},
      ignition_fuel{"ignition_fuel_power", std::nullopt, "b, the power of 1 - lambda", powers},
      ignition_power{"ignition_power", std::nullopt, "x, the power of the compression beyond a", powers},
      growth{"growth", Dimension::rate, "G, the rate of growth at growth_pressure", not_negative},
      pressure{"growth_pressure", Dimension::pressure, "P_ref", positive},
      growth_fuel{"growth_fuel_power", std::nullopt, "c, the power of 1 - lambda", powers},
      growth_product{"growth_product_power", std::nullopt, "d, the power of lambda", powers},
      growth_power{"growth_power", std::nullopt, "y, the power of the pressure", powers};

  double I, a, b, x, G, P_ref, c, d, y;

  static std::vector<KineticsKind<PressureBurn>> kinds() {
    return {{"pressure",
             "ignition by compression and growth by pressure",
             {ignition, threshold, ignition_fuel, ignition_power, growth, pressure, growth_fuel,
              growth_product, growth_power},
             [](auto v) { return PressureBurn{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]}; }}};
  }
  PressureBurn in_units(ReducedUnits const& units) const {
    auto law = *this;
    law.I *= units.time(), law.G *= units.time(), law.P_ref /= units.pressure();
    return law;
  }
  Rates rates(LocalState const& at) const {
    double const fuel = 1 - at.progress, beyond = at.rho - 1 - a;
    if (!(fuel > 0))
      return {};
    double rate = 0;
    if (beyond > 0)
      rate += I * std::pow(fuel, b - 1) * std::pow(beyond, x);
    if (at.P > 0)
      rate += G * std::pow(fuel, c - 1) * std::pow(at.progress, d) * std::pow(at.P / P_ref, y);
    return {rate, 0};
  }
  double longest_change(double, double, double) const { return usual_change; }
};

} // namespace mesobridge::sdpd
