#pragma once
#include "fitting/shock_relations.hpp"
#include "workflows/report/report.hpp"
#include "workflows/shock_study/shock_runs.hpp"

namespace mesobridge::workflows {

/// Standard errors of a shock's four numbers, SI.
struct ShockErrors {
  double v_S, rho, P, T;
};

/// A shock by the relations of Rankine and Hugoniot, and by which equation of state.
struct NamedShock {
  std::string key;  ///< for programs: "argon"
  std::string name; ///< for people: "BWR of 1993"
  fitting::Shock shock;
  fitting::Shock cut = shock;                   ///< if the potential is cut as in molecular dynamics
  std::optional<ShockErrors> se = std::nullopt; ///< of both, where the equation was fitted to data
};

/// One of argon: "argon", "lj-kn" or "lj-thol" at rho, T [SI] before a piston; in SI. Throws PhysicsError
/// where the equation has no such shock.
fitting::Shock argon_shock(std::string const& material, double rho, double T, double v_P);

/// Lennard-Jones argon at rho, T [SI] before a piston, by every equation of state of it that is built in;
/// first that of the particles (BWR). All in SI. Those of the cut potential have the mean field of what lies
/// beyond `cutoff` [sigma] taken away (fitting/README.md, Eq. (F27)). Throws PhysicsError.
std::vector<NamedShock> argon_shocks(double rho, double T, double v_P, double cutoff = 4);

/// The same by an equation fitted to molecular dynamics of the whole potential, a file of `fit lj-bwr`, with
/// standard errors by its covariance. Throws InputError that names --fit for a file that is none or whose
/// equation has no such shock.
NamedShock fitted_argon_shock(std::string const& file, double rho, double T, double v_P, double cutoff = 4);

/// The states of the cut potential by each equation, and how far molecular dynamics is from them in standard
/// errors, with a sentence that says which equations are off. Without a row of molecular dynamics the states
/// alone.
Section equations_section(ShockRow const* md, std::vector<NamedShock> const& equations);

/// A list of {equation, v_S_m_s, ... and the same four of the cut potential in `cut_potential`}, with
/// standard errors where there are any, and in `md_less_cut_potential_in_se` the differences.
Json equations_json(ShockRow const* md, std::vector<NamedShock> const& equations);

} // namespace mesobridge::workflows
