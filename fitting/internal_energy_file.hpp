#pragma once
#include "fitting/internal_energy.hpp"
#include <map>
#include <string>
#include <string_view>

namespace mesobridge::fitting {

/// The internal energy of a DPDE particle as it stands in a file:
///
///     format = "mesobridge internal energy 1"
///     kind = "constant" | "heat-capacity" | "entropy"
///     temperature_unit = "K" | "reduced"
///     data_hash = "..."             # of the data that were fitted; may be left out
///
///     [constant]                    # kind "constant"
///     C_kB = 60.0                   # heat capacity of a particle over k_B
///
///     [heat_capacity]               # kind "heat-capacity": C(T), valid between its first and last T
///     points = 4
///     T = [...]
///     C_kB = [...]
///     eps_min_over_kB = 0.0         # internal energy over k_B at the first T, in the unit of temperature
///
///     [entropy]                     # kind "entropy": S(eps), valid from the second point to the last but
///     one points = 5 eps_over_kB = [...] S_kB = [...]
///
///     [provenance]                  # texts; may be left out
struct InternalEnergyModel {
  AnyInternalEnergy internal_energy;
  bool reduced = false;                          ///< temperatures are not in kelvin
  std::string data_hash;                         ///< empty if none
  std::map<std::string, std::string> provenance; ///< whatever the caller wants to remember
};

/// TOML text from which parse_internal_energy returns the same model bit for bit.
std::string to_toml(InternalEnergyModel const& model);

/// Throws InputError with file, line, key and what is allowed.
InternalEnergyModel parse_internal_energy(std::string_view text, std::string const& file_name);

} // namespace mesobridge::fitting
