#pragma once
#include "fitting/shock_profile.hpp"
#include "workflows/lj/piston_file.hpp"
#include "workflows/report/report.hpp"
#include "workflows/reproduce/published.hpp"
#include "workflows/sdpd/shock.hpp"
#include "workflows/shock_study/argon_equations.hpp"

namespace mesobridge::workflows {

/// What a run by molecular dynamics has found; the motion is that of the molecules' centres where atoms are
/// bound.
ShockData shock_data_of(PistonData const& data);

/// The row of a run by molecular dynamics.
ShockRow md_row(PistonData const& data, ShockOfRun const& shock);

/// v_S_m_s, rho_kg_m3, P_Pa, T_K.
Json shock_json(fitting::Shock const& shock);

/// model, K, Re_l and the measured four with _se; with the row's printed values where the table has them, and
/// `failure` alone where the run could not go on.
Json row_json(ShockRow const& row, PublishedTable const& printed, std::string const& printed_row);

/// The rows beside each other, with what was printed (a row of the table by its name, empty: none) and what
/// the equations of state say.
struct ShownRow {
  std::string label;
  ShockRow const& row;
  std::string printed_row;
};
Table shock_table(std::vector<ShownRow> const& rows, std::vector<NamedShock> const& exact,
                  PublishedTable const& printed, std::string const& caption);

/// The differences of v_S, rho (mass per volume), P and T from the relations that are farthest beyond the
/// bound (0.01: 1 %), in their standard errors, over some rows.
std::vector<VerdictLine> shock_verdicts(std::vector<ShockRow> const& rows, fitting::Shock const& exact,
                                        double bound, std::string const& of);

/// Densities in the frame of the front, in nanometres or in the spacings of each row's own particles, beside
/// the Navier-Stokes profile where there is one; the level lines are the states of `exact`.
Plot front_plot(std::string const& name, std::string const& title, std::vector<ShownRow> const& rows,
                std::optional<fitting::ShockProfile> const& navier_stokes, fitting::Shock const& exact,
                std::optional<double> spacing);

} // namespace mesobridge::workflows
