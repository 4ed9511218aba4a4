#pragma once
#include "fitting/fit_eos.hpp"

namespace mesobridge::fitting {

/// The observations as seen by a family of models: whitened residuals and what must be positive.
class EosProblem {
 public:
  /// Throws InputError for incomplete observations.
  EosProblem(EosFamily const& family, std::vector<Observation> const& data, EosRegion const& region);

  Eigen::VectorXd residuals(Eigen::VectorXd const& values) const;
  /// (dP/drho)_s in (km/s)^2 over the region and at the states of shocks, isentropes and detonations.
  Eigen::VectorXd sound_speeds_squared(Eigen::VectorXd const& values) const;
  /// State and predictions of one observation.
  ReachedState reached(Observation const& observation, Eigen::VectorXd const& values) const;
  Eigen::VectorXd predictions(Observation const& observation, Eigen::VectorXd const& values) const;

  /// Takes the errors of given quantities into the noise, by the slopes of the model at these values. Returns
  /// false when all given quantities are exact: nothing was to be done.
  bool renew_noise(Eigen::VectorXd const& values);
  /// Standard errors of one observation's data, as they enter the fit.
  Eigen::VectorXd standard_errors(std::size_t observation) const;

 private:
  Eigen::MatrixXd measurement_noise(Observation const& observation) const;

  EosFamily const& family_;
  std::vector<Observation> const& data_;
  EosRegion region_;
  Eigen::Index size_ = 0;
  std::vector<Eigen::MatrixXd> noise_;     ///< covariance of each observation
  std::vector<Eigen::MatrixXd> whitening_; ///< inverse of its Cholesky factor
};

/// One quantity where an observation leads to in the model with these parameters.
double predicted(EosFamily const& family, Observation const& observation, Quantity quantity,
                 Eigen::VectorXd const& values);

} // namespace mesobridge::fitting
