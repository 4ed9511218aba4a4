#pragma once
#include "fitting/eos_data.hpp"
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// What a column of a data file holds: a quantity, of the state or of the start of a shock or isentrope, or
/// its standard error; or a number without unit.
struct DataColumn {
  enum class Role { value, standard_error, start, start_error, P_e_correlation };
  Role role = Role::value;
  fitting::Quantity quantity = fitting::Quantity::P;
  double factor = 1; ///< SI = factor * number
};

/// Reads a column's name: a quantity and its unit, `P_GPa`; its standard error, `P_se_GPa` or `P_GPa_se`; a
/// quantity of the start, `rho0_kg_m3`; `P_e_correlation`. Units may be written in all usual ways
/// (`rho0_g_cc`, `P [GPa]`, `Us (km/s)`, `rho_kg_m-3`), quantities by their usual other names (`up`, `Us`,
/// `T_0`). Throws InputError that says what is allowed, without the file's name; it never proposes another
/// unit.
DataColumn parse_data_column(std::string const& name);

/// Columns that may stand in a file and are not read: `phase`, `source`, `comment` ...
bool is_remark(std::string const& name);

/// Quantities that follow from others at the same state, which `eos table` writes and no fit needs:
/// `s_J_kg_K`, `gruneisen`, `sound_speed_squared_m2_s2`.
bool is_derived(std::string const& name);

/// All quantities, each with its units: {"rho", "kg_m3, g_cm3, ..."}.
std::vector<std::pair<std::string, std::string>> data_columns_and_units();

/// All quantities with their units, for help and messages: "rho [kg_m3, g_cm3], ...".
std::string known_data_columns();

} // namespace mesobridge::workflows
