#pragma once
#include "cg/histogram.hpp"
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/simulation.hpp"
#include <functional>
#include <string>

namespace mesobridge::sdpd {

/// One short run that says how a scheme and a time step do.
struct Trial {
  SimulationSettings settings;
  std::int64_t settle = 0, steps = 0, sample_every = 1; ///< steps before the samples, and sampled ones
  cg::Bins bins;                                        ///< of eps / k_B T
};

/// What a trial has found, in reduced units. A run that failed says how and has nothing else but its
/// energies until then and, when there were enough of them, the drift that led there.
struct TrialResult {
  std::string failure; ///< empty: it went through
  double dt = 0;
  double settled = 0; ///< reduced time before the first sample
  cg::Estimate T_kin, T_int, P;
  cg::Estimate D;                      ///< self-diffusion in the trial's box; se = 0: it could not be told
  cg::Estimate eps_mean, eps_variance; ///< over the particles, in k_B T and its square
  /// Slope of (E - E_0)/|E_0|, while the energy that was gained or lost changes the temperature by 2 % at
  /// most: the rate rises steeply with the temperature.
  Drift drift_of_mean;
  Drift drift_of_walk;        ///< the same from the walk of the energy (se = 0: not applicable)
  bool drift_unknown = false; ///< the temperature changed too soon
  double rejected_out_of_domain = 0, rejected_metropolis = 0; ///< shares of all pairs' steps
  double us_per_particle_step = 0;                            ///< processor time
  cg::Bins bins;
  double E_0 = 0, heat_capacity = 0;           ///< reduced energy at the start; dE/dT in k_B
  std::vector<double> first_half, second_half; ///< histograms of eps, normalised, of the two halves
  std::vector<double> times, energies;         ///< thinned; energies as (E - E_0)/|E_0|

  bool failed() const { return !failure.empty(); }
  bool knows_drift() const { return !drift_unknown && (!failed() || drift_of_mean.se > 0); }
  /// The better known of the two; that of the mean where they disagree by more than four standard errors.
  Drift drift() const;
  std::vector<double> histogram() const;
};

/// An equilibrated state of the settings' fluid and size, made with the exact scheme (SSA for DPD) and a
/// short time step.
Checkpoint equilibrated_start(SimulationSettings settings, double dt, double time,
                              std::function<bool()> const& keep_going);

/// Runs a trial from a state that trials of its size share. Failures of the physics are results. Throws
/// Interrupted when `keep_going`, which is told the steps done, says no.
TrialResult run_trial(Trial const& trial, Checkpoint const& start,
                      std::function<bool(std::uint64_t)> const& keep_going);

} // namespace mesobridge::sdpd
