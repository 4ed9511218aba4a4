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

/// The Chapman-Jouguet state of a fitted model: from the explosive of the data, where a row of kind `cj`
/// gives one, or else from that of the JWL model itself (rho_0, E_0, P = 0); nothing for others.
struct FittedDetonation {
  fitting::StartState explosive; ///< e on the data's scale
  cg::Estimate D, rho, P, T;
};
std::optional<FittedDetonation> fitted_detonation(fitting::EosFit const& fit);

/// Says that the fit is a bad one, where a chi^2 like its own has a probability below 0.001.
std::optional<std::string> bad_fit(fitting::FitOutcome const& outcome);

/// What the fitted model says of a state at rest from which shocks of the data start, or else of the least
/// density at the coldest temperature of the data.
struct FittedRest {
  double rho, T;
  cg::Estimate P, e, sound_speed;
};
std::optional<FittedRest> fitted_rest(fitting::EosFit const& fit);

/// Probability of a chi^2 at least as large as the fit's if model and errors are right; nothing without
/// degrees of freedom.
std::optional<double> chi_2_probability(fitting::FitOutcome const& outcome);

} // namespace mesobridge::workflows
