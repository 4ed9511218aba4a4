#pragma once
#include "fitting/eos/lj_bwr.hpp"
#include <cmath>

namespace mesobridge::fitting {

/// A box of states in Lennard-Jones units.
struct LjRegion {
  double rho_min, rho_max, T_min, T_max;

  bool contains(double rho, double T) const {
    return rho >= rho_min && rho <= rho_max && T >= T_min && T <= T_max;
  }
};

/// Evenly spaced densities and logarithmically spaced temperatures, corners included.
/// visit(rho, T) is called for each.
template <class Visit>
void for_each_state(LjRegion const& region, int densities, int temperatures, Visit&& visit) {
  for (int i = 0; i < densities; ++i)
    for (int j = 0; j < temperatures; ++j) {
      double const rho = std::lerp(region.rho_min, region.rho_max, double(i) / (densities - 1));
      double const log_T =
          std::lerp(std::log(region.T_min), std::log(region.T_max), double(j) / (temperatures - 1));
      visit(rho, j + 1 == temperatures ? region.T_max : std::exp(log_T));
    }
}

/// How far a set is from thermal and mechanical instability, in Lennard-Jones units per atom.
struct LjStability {
  double c_v_min; ///< smallest c_v/k_B over the region
  double rho_at_c_v_min, T_at_c_v_min;
  int unstable;                    ///< states with c^2 <= 0 where the published set is clearly stable
  double rho_unstable, T_unstable; ///< one of them
  int states;                      ///< examined

  bool stable() const { return c_v_min > 0 && unstable == 0; }
};

/// Examines a grid of states over the region. The published set itself has a liquid-gas region, where c^2 < 0
/// is right, and is about to fail in the solid's corner (rho* = 1.3, T* < 1), where c^2 is a small difference
/// of large terms. Hence c^2 is asked for only where the published c^2 exceeds a fifth of the summed
/// magnitudes of its two terms.
LjStability stability(LjBwrSet const& set, LjRegion const& region);

} // namespace mesobridge::fitting
