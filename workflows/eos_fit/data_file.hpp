#pragma once
#include "fitting/eos_data.hpp"
#include <filesystem>
#include <map>
#include <optional>

namespace mesobridge::workflows {

/// Standard errors for data that have none, relative to their values.
struct RelativeErrors {
  std::optional<double> all;
  std::map<fitting::Quantity, double> of; ///< by quantity; goes before `all`
};

struct EosData {
  std::vector<fitting::Observation> observations;
  std::vector<std::string> notes; ///< what was read but not used, and why
};

/// Reads observations from a CSV file (as parse_csv understands it; empty cells are allowed), or from an HDF5
/// file with one dataset a column in one group, or the tables that `eos table` writes.
///
/// A row is a `state`, a shocked state (`hugoniot`), a state on an `isentrope` or a Chapman-Jouguet state
/// (`cj`), as its column `kind` says; without it, rows with rho0 are shocked states, others states. States
/// are given by rho and T, or rho and e; the rest was measured. A shock has one independent quantity besides
/// its strength: of rho, P, v_P, v_S two are used (rho and P where rho is exact and P has an error; otherwise
/// v_P and v_S); the others, which follow from them, must not contradict them. A shock with v_P = 0 measures
/// the sound speed of matter at rest.
///
/// Throws InputError with file, line, column and what is allowed.
EosData read_eos_data(std::filesystem::path const& file, RelativeErrors const& errors);

/// Parses "0.01" for all quantities or "P=0.01" for one. Throws InputError.
void add_relative_error(RelativeErrors& errors, std::string const& text);

} // namespace mesobridge::workflows
