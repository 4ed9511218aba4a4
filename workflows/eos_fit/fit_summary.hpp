#pragma once
#include "fitting/fit_eos.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// "_Pa" for P: the end of a quantity's key in JSON.
std::string si_suffix(fitting::Quantity quantity);

/// Parameters with their errors and correlations, quality of the fit, every datum beside it.
Json eos_fit_json(fitting::EosFit const& fit);

/// The same in a table for people.
std::string eos_fit_text(fitting::EosFit const& fit);

/// The Chapman-Jouguet state of a fitted JWL model from its own explosive (rho_0, E_0, P = 0): D, rho, P, T.
struct FittedDetonation {
  cg::Estimate D, rho, P, T;
};
std::optional<FittedDetonation> fitted_detonation(fitting::EosFit const& fit);

/// Probability of a chi^2 at least as large as the fit's if model and errors are right; nothing without
/// degrees of freedom.
std::optional<double> chi_2_probability(fitting::FitOutcome const& outcome);

} // namespace mesobridge::workflows
