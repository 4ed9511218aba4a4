#pragma once
#include "workflows/shock_study/argon_equations.hpp"

namespace mesobridge::workflows {

/// One of the four numbers that a shock is told by.
struct ShockQuantity {
  std::string name, unit, key;
  double factor; ///< from SI to the printed unit
  std::string printed;
  double printed_factor; ///< from the printed unit to SI
  cg::Estimate ShockRow::*of_row;
  double (*of_shock)(fitting::Shock const&);
  double ShockErrors::*error;
};

/// v_S, rho, P, T.
std::vector<ShockQuantity> const& shock_quantities();

/// A row's value that is compared with the relations: as rho the mass per volume, since the particles' own
/// densities are a sum over neighbours.
cg::Estimate judged(ShockRow const& row, ShockQuantity const& quantity);

/// A value in the quantity's unit, with five digits.
std::string digits_of(ShockQuantity const& quantity, double si);

} // namespace mesobridge::workflows
