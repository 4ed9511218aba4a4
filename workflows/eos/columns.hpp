#pragma once
#include "fitting/shock_relations.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// One quantity of one state or of many along a curve. In SI its key ends in the unit: P_Pa; reduced
/// (Lennard-Jones) models print the bare key.
struct Column {
  std::string key;
  std::string si_suffix;
  std::string unit; ///< for people
  /// Absent where a state has no such quantity: no sound speed where it is mechanically unstable.
  std::vector<std::optional<double>> values;

  std::string name(bool reduced) const { return reduced ? key : key + si_suffix; }
};

using Columns = std::vector<Column>;

/// rho, T, P, e, s, c_v, sound_speed, gruneisen.
Columns state_columns(std::vector<fitting::EosState> const& states);
/// v_P, v_S, then the columns of the states behind.
Columns shock_columns(std::vector<fitting::Shock> const& shocks);

/// Throws PhysicsError that names the first row with a value that is no finite number: none is ever printed.
void require_numbers(Columns const& columns);

/// The first row as scalars, without what is absent; `prefix` goes before each key.
void put_first_row(Json& object, Columns const& columns, bool reduced, std::string const& prefix = "");
/// The columns as arrays; null where absent.
Json arrays(Columns const& columns, bool reduced);
/// A head of keys, then comma-separated rows, with the shortest texts that read back to the same numbers;
/// empty where absent.
std::string csv_text(Columns const& columns, bool reduced);
/// The first row as a result: its scalars, and for people a line a quantity.
void tell_first_row(Result& result, Columns const& columns, bool reduced);

} // namespace mesobridge::workflows
