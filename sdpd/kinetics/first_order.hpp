#pragma once
#include "sdpd/kinetics/arrhenius.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

/// Each particle reacts by itself, d lambda/dt = K(T) (1 - lambda) - K_back(T) lambda (sdpd/README.md, Eq.
/// (S61)).
struct FirstOrder {
  Arrhenius forward, back;

  static std::vector<KineticsKind<FirstOrder>> kinds() {
    return arrhenius_kinds<FirstOrder>("first-order", "each particle by itself, by Arrhenius",
                                       "first-order-reversible", "and back");
  }
  FirstOrder in_units(ReducedUnits const& units) const {
    return {forward.in_units(units), back.in_units(units)};
  }
  Rates rates(LocalState const& at) const { return {forward(at.T), back.acts() ? back(at.T) : 0}; }
  double longest_change(double T, double c, double heat) const {
    return change_by_heat(std::max(forward.T_a, back.acts() ? back.T_a : 0), T, c, heat);
  }
};

} // namespace mesobridge::sdpd
