#pragma once
#include "md/input_lines.hpp"
#include <string_view>
#include <vector>

namespace mesobridge::workflows {

/// A bond style of LAMMPS that a mapping holds, and the names of its coefficients, which both have.
struct BondStyle {
  std::string_view name;
  std::vector<char const*> coefficients;
};

/// Null for any other style.
BondStyle const* bond_style_named(std::string_view name);

/// Those of a line "bond_coeff 1 30 1.5 1 1". Throws InputError for too few, too many, and for numbers out of
/// their range.
std::vector<double> bond_coefficients(md::InputLine const& line, BondStyle const& style);

} // namespace mesobridge::workflows
