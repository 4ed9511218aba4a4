#pragma once
#include "cg/state_grid.hpp"
#include "fitting/eigen.hpp"
#include "fitting/eos/lj_bwr.hpp"
#include "fitting/eos/lj_bwr_stability.hpp"
#include "fitting/lj_bwr_problem.hpp"
#include <limits>
#include <optional>
#include <vector>

namespace mesobridge::fitting {

struct LjBwrFitOptions {
  LjBwrPrior prior = LjBwrPrior::published;
  /// Relative prior uncertainty of U and P; without a value, that of largest evidence: in [2e-4, 0.5] for
  /// `published`, in [1e-2, 1e6] for `none`.
  std::optional<double> prior_width = std::nullopt;
  /// Search gamma in [2, 4] for the largest evidence (NLopt); otherwise it stays at the published 3.
  bool fit_gamma = false;
  /// Systematic relative errors of the data (finite size, cut-off), added in quadrature to the standard
  /// errors: of P in units of max(|P|, rho T), of U in units of max(|U|, T).
  double relative_error_floor = 0;
  /// Where the continuation with constant heat capacity begins; data below are refused. Default: three
  /// quarters of the coldest state's temperature, but not below the published set's. Far below the data the
  /// inverse powers of T, once corrected, have no hold: on real data the heat capacity turned negative there.
  std::optional<double> T_low;
  /// 0: leave out one state at a time; k >= 2: leave out every k-th state together (k folds).
  int folds = 0;
};

/// One state of the data beside the fit, Lennard-Jones units per atom. "Deviations" are in standard errors.
struct LjBwrFitPoint {
  double rho, T;
  double U, U_se, P, P_se;                 ///< data; the errors include the systematic floor
  double U_fit, U_fit_se, P_fit, P_fit_se; ///< fit, and its own uncertainty
  double U_published, P_published;         ///< Johnson et al. 1993
  double U_deviation, P_deviation;         ///< (data - fit)/(data's standard error)
  double U_held_out, U_held_out_se; ///< prediction by the fit without this state; se of data - prediction
  double P_held_out, P_held_out_se;
  double U_held_out_deviation, P_held_out_deviation; ///< (data - prediction)/(that se)
};

struct LjBwrFit {
  LjBwr eos; ///< in Lennard-Jones units; `eos.in_units(argon_units)` for SI
  /// Lower triangular L of the parameters' covariance L L^T, gamma and prior width held fixed. The parameters
  /// are so correlated that uncertainties of predictions must be formed from L: the length of L^T row.
  Eigen::MatrixXd covariance_factor;
  double prior_width;    ///< used, after strengthening
  double evidence_width; ///< that of largest evidence, or the one given
  int strengthened;      ///< how many times the prior was halved to keep the fit physical
  double log_evidence;
  double condition; ///< of the data alone in the prior's metric; infinite if they lack rank
  double condition_regularised;
  double effective_parameters; ///< of 32, how many the data determine
  double chi_2;                ///< sum of squared whitened residuals of the 2 n data
  double degrees_of_freedom;   ///< 2 n - effective parameters
  std::vector<LjBwrFitPoint> points;
  double held_out_fraction;      ///< of the states, predicted within 3 combined standard errors in U and in P
  double rms_held_out_deviation; ///< over U and P; about 1 when the errors are what they claim
  LjRegion sampled;              ///< box of the data
  double e_min, e_max;           ///< energies per atom of the data
  LjRegion checked;              ///< where c_v > 0 and c^2 > 0 were verified
  LjStability stability;

  Eigen::MatrixXd covariance() const { return covariance_factor * covariance_factor.transpose(); }
  /// U and P at a state (rho, T >= T_low) with the uncertainty that the fit leaves.
  struct Prediction {
    double U, U_se, P, P_se;
  };
  Prediction predict(double rho, double T) const;

  /// Largest differences from another equation over a grid of states in the sampled box: of P in units of
  /// max(|P|, rho T), of U in units of max(|U|, T) (U crosses zero).
  struct Difference {
    double P, U;
  };
  /// From the published BWR set, up to T_max: its simulations ended at T* = published_T_max, above it
  /// extrapolates.
  Difference difference_from_published(double T_max = std::numeric_limits<double>::infinity()) const;
  /// From the equation of Kolafa and Nezbeda (1994), which is valid up to T* = 20 and has no part in the fit.
  Difference difference_from_kolafa_nezbeda() const;
  static constexpr double published_T_max = 6;
};

/// Fits the 32 linear parameters to U and P of the grid together, whitened by their 2 x 2 covariances.
///
/// With the published prior the data correct the 1993 equation: some 30 states of 0.2 % determine about 10
/// combinations of the parameters, the prior holds the others, and far from the data the published equation
/// stands. The prior width is the one of largest evidence. If need be it is halved until the fit is stable
/// over the checked region, which becomes the model's domain: rho* <= 1.3, T* <= 100 (examined from rho* 0.01
/// and T_low); without the published prior, the sampled box.
///
/// Throws InputError for too few states (3; 20 without the published prior), data that are not finite, errors
/// that are not > 0, temperatures below T_low; PhysicsError when no prior width gives a stable fit.
LjBwrFit fit_lj_bwr(cg::StateGrid const& grid, LjBwrFitOptions const& options = {});

} // namespace mesobridge::fitting
