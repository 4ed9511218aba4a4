#pragma once
#include "fitting/internal_energy.hpp"
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace mesobridge::fitting {

/// Columns of a table over the distance of two particles, by their names: "r" and others as long.
using PairColumns = std::map<std::string, std::vector<double>>;

/// What a coarse particle is, as it stands in a file: its internal energy and, where they are known, its mass
/// and what two of them do to each other.
///
///     format = "mesobridge particle 1"
///     kind = "constant" | "heat-capacity" | "entropy"
///     temperature_unit = "K" | "reduced"
///     data_hash = "..."             # of the data that were fitted; may be left out, as all that follows but
///                                   # the table of the kind
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
///     [entropy]                     # kind "entropy": S(eps), valid from the second point to the last but one
///     points = 5
///     eps_over_kB = [...]
///     S_kB = [...]
///
///     [state]                       # the fluid that it was found in
///     rho = 0.3
///     T = 1.0
///
///     [particle]
///     mass = 19.0
///
///     [potential]                   # of two particles at the distance r, as in the files that a scene names
///     points = 3
///     r = [...]
///     u = [...]                     # and perhaps the force f
///
///     [friction]
///     points = 3
///     r = [...]
///     gamma_par = [...]             # and perhaps gamma_perp
///
///     [conduction]
///     points = 3
///     r = [...]
///     kappa = [...]
///
///     [provenance]                  # texts
///
/// With temperatures in kelvin the keys are in SI and say so: rho_kg_m3, mass_kg, r_m, u_J, f_N,
/// gamma_par_kg_s, gamma_perp_kg_s, kappa_W_K. Columns may be followed by their standard errors, u_se say,
/// which nobody needs to read. Files that begin with "mesobridge internal energy 1" are read too.
struct ParticleModel {
  struct State {
    double rho, T;
    bool operator==(State const&) const = default;
  };

  AnyInternalEnergy internal_energy;
  bool reduced = false;                             ///< temperatures are not in kelvin
  std::string data_hash = {};                       ///< empty if none
  std::map<std::string, std::string> provenance = {}; ///< whatever the caller wants to remember
  std::optional<double> mass = {};
  std::optional<State> state = {};
  PairColumns potential = {}, friction = {}, conduction = {}; ///< empty where they are not known
};

/// TOML text from which parse_particle_model returns the same model bit for bit.
std::string to_toml(ParticleModel const& model);

/// Throws InputError with file, line, key and what is allowed.
ParticleModel parse_particle_model(std::string_view text, std::string const& file_name);

} // namespace mesobridge::fitting
