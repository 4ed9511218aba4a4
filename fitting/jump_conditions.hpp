#pragma once
#include "fitting/eos_data.hpp"

namespace mesobridge::fitting {

/// A shock by what conservation of mass and momentum alone say, whatever the matter:
///   rho_0 v_S = rho (v_S - v_P),  P = P_0 + rho_0 v_S v_P.
struct Jump {
  double rho, P, v_P, v_S;

  /// One of the four.
  double of(Quantity quantity) const;
};

/// The shock into matter at rest with these two of rho, P, v_P, v_S. Numbers that no shock can have give one
/// that is not finite.
Jump jump_of(double rho_0, double P_0, Datum const& a, Datum const& b);

/// A stated quantity that contradicts two others by more than five standard errors and half a percent, the
/// rounding of tables.
struct Contradiction {
  Datum stated;
  double by_jump; ///< what the two others demand
};
std::optional<Contradiction> contradiction(double rho_0, double P_0, Datum const& a, Datum const& b,
                                           std::vector<Datum> const& others);

} // namespace mesobridge::fitting
