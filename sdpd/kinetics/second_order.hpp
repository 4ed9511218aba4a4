#pragma once
#include "sdpd/kinetics/arrhenius.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

/// How a neighbour counts in the rate of a pair law.
enum class NeighbourWeights {
  kernel,    ///< w_ij = m_j W_ij in reduced units, without the particle itself: the thesis's
  normalised ///< w_ij = m_j W_ij/rho_j, with the particle itself: their sum is one in a uniform fluid
};

/// Pairs react, d lambda_i/dt = sum_j w_ij [K(T_ij) (1 - lambda_i)(1 - lambda_j) - K_back(T_ij) lambda_i
/// lambda_j] with T_ij = (T_i + T_j)/2 (sdpd/README.md, Eq. (S62)).
struct SecondOrder {
  Arrhenius forward, back;
  NeighbourWeights weights = NeighbourWeights::kernel;

  static std::vector<KineticsKind<SecondOrder>> kinds() {
    return arrhenius_kinds<SecondOrder>("second-order", "pairs of unburnt particles react, by Arrhenius",
                                        "second-order-reversible", "and pairs of burnt ones go back");
  }
  SecondOrder in_units(ReducedUnits const& units) const {
    return {forward.in_units(units), back.in_units(units), weights};
  }
  double longest_change(double T, double c, double heat) const {
    return change_by_heat(std::max(forward.T_a, back.acts() ? back.T_a : 0), T, c, heat);
  }
};

} // namespace mesobridge::sdpd
