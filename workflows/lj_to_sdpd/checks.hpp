#pragma once
#include "workflows/lj_to_sdpd/results.hpp"
#include "workflows/report/check.hpp"

namespace mesobridge::workflows {

/// What the published equations of the Lennard-Jones fluid may be wrong by, relative, of P in units of
/// max(|P|, rho T) and of U in units of max(|U|, T): those of Kolafa and Nezbeda and of Thol et al. were
/// fitted to different simulations, and either may be the reason for all of their differences, whose root
/// mean square at the states of the fit where both are valid, up to T* = 9, this is. Beyond, where only the
/// first is left, the same is taken.
struct PublishedAccuracy {
  double P, U;
};
PublishedAccuracy published_accuracy(std::vector<fitting::LjBwrFitPoint> const& points);

/// U and P of every state of the data, with the errors of the data, beside a published equation, up to its
/// T_max. `equation`: a name of `eos list` in Lennard-Jones units.
std::vector<Comparison> data_against(std::vector<fitting::LjBwrFitPoint> const& points,
                                     std::string const& equation, PublishedAccuracy accuracy);

/// U and P of the fit at one state with the fit's own uncertainty, beside a published equation.
std::vector<Comparison> fit_against(fitting::LjBwrFit const& fit, double rho, double T,
                                    std::string const& equation, PublishedAccuracy accuracy);

/// Both temperatures of a run in kelvin beside the set one.
std::vector<Comparison> temperatures_of(RunResult const& run);

/// Pressure [GPa] and mean density [kg/m^3] of a run beside those of its equation of state, which its
/// densities are calibrated to, within the errors of that calibration.
std::vector<Comparison> state_of(RunResult const& run);

/// The lines at the head of the chain's report.
std::vector<VerdictLine> chain_checks(ChainResults const& results);

} // namespace mesobridge::workflows
