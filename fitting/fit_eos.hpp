#pragma once
#include "fitting/eos/list.hpp"
#include "fitting/eos_data.hpp"
#include "fitting/fit.hpp"
#include "fitting/model_file.hpp"
#include "fitting/predict_data.hpp"
#include <map>
#include <span>

namespace mesobridge::fitting {

/// A model whose parameters are fitted, with default bounds that suit the data.
struct EosFamily {
  std::string name; ///< "mie-gruneisen"
  /// Those of the model in the order of its file, then `energy_offset`: an energy of the data minus that of
  /// the model at the same state.
  std::vector<Parameter> parameters;
  std::function<AnyEos(Eigen::VectorXd const&)> build; ///< ignores energy_offset
  std::function<Eigen::VectorXd(AnyEos const&)>
      values_of; ///< of the model alone; throws InputError for another
};

/// Where the fitted model must be physical: c_v > 0 and (dP/drho)_s > 0.
struct EosRegion {
  double rho_min, rho_max, T_min, T_max;
};

/// What the user decides about the parameters; names as in EosFamily, with or without units ("K_s",
/// "K_s_Pa").
struct EosFitOptions {
  std::map<std::string, double> fixed, start;
  std::map<std::string, std::pair<double, double>> bounds; ///< bounded parameters are free
  std::vector<std::string> free;                           ///< free ones that are fixed by default
  std::optional<AnyEos> from;      ///< start values, and values of what stays fixed, from this model
  std::optional<EosRegion> region; ///< default: the box of the data
  FitOptions search;
  int bootstrap = 0; ///< refits; 0: none
};

/// One measured quantity beside the fit.
struct FittedDatum {
  Quantity quantity;
  double value, se; ///< se: with the errors of what was given, carried through the model
  double fit, fit_se;
  double deviation() const { return (value - fit) / se; }
};

struct FittedObservation {
  Observation observation;
  ReachedState state; ///< in the fitted model; energies on the model's scale
  std::vector<FittedDatum> data;
};

struct EosFit {
  EosFamily family;
  AnyEos eos;
  FitOutcome outcome;
  std::optional<Bootstrap> bootstrap;
  std::vector<FittedObservation> observations;
  EosRegion region; ///< where it was required to be physical
  double c_2_min;   ///< least (dP/drho)_s there [m^2/s^2]
  ValidRange valid; ///< box of the states of the data in the model
  double energy_offset;

  /// The model ready to be written.
  EosModel model(std::string data_hash, std::map<std::string, std::string> provenance) const;
  /// What the fitted model says would be measured of a quantity, with the standard error that the fit leaves.
  /// Throws PhysicsError when the observation is out of the model's reach.
  cg::Estimate estimate(Observation const& observation, Quantity quantity) const;
  /// The same without the standard error.
  double value(Observation const& observation, Quantity quantity) const;
};

/// Weighted least squares. Errors of P and e may be correlated; errors of given quantities count by the slope
/// of the model (effective variance), renewed with the fit until they agree.
///
/// Throws InputError for incomplete observations, unknown parameter names, bounds out of order; PhysicsError
/// when no parameters within the bounds give a physical model that reaches all data.
EosFit fit_eos(EosFamily family, std::vector<Observation> data, EosFitOptions const& options = {});

} // namespace mesobridge::fitting
