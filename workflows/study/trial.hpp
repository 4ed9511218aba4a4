#pragma once
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/state/checkpoint.hpp"
#include "workflows/command.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// Equal bins of eps / k_B T for the distribution of the internal energies.
struct EnergyBins {
  double lower = 0, upper = 0;
  std::size_t count = 150;

  double width() const { return (upper - lower) / static_cast<double>(count); }
};

/// One short run of a study. `scene.run` says how many steps settle (equilibrate) and how many are sampled;
/// the particles begin in a state that all trials of a size share.
struct Trial {
  std::string name; ///< of its file; unique in a study
  Scene scene;
  EnergyBins bins;
};

/// What a trial has found, in reduced units. A run that failed says how and has nothing else but its
/// energies until then and, when there were enough of them, the drift that led there.
struct TrialResult {
  std::string failure; ///< empty: it went through
  double dt = 0;
  double settled = 0; ///< reduced time before the first sample
  cg::Estimate T_kin, T_int, P;
  cg::Estimate eps_mean, eps_variance; ///< over the particles, in k_B T and its square
  /// Slope of (E - E_0)/|E_0|, while the energy that was gained or lost changes the temperature by 2 % at
  /// most: the rate rises steeply with the temperature.
  sdpd::Drift drift_of_mean;
  sdpd::Drift drift_of_walk;  ///< the same from the walk of the energy (se = 0: not applicable)
  bool drift_unknown = false; ///< the temperature changed too soon
  double rejected_out_of_domain = 0, rejected_metropolis = 0; ///< shares of all pairs' steps
  double us_per_particle_step = 0;                            ///< processor time
  EnergyBins bins;
  double E_0 = 0, heat_capacity = 0;           ///< reduced energy at the start; dE/dT in k_B
  std::vector<double> first_half, second_half; ///< histograms of eps, normalised, of the two halves
  std::vector<double> times, energies;         ///< thinned; energies as (E - E_0)/|E_0|

  bool failed() const { return !failure.empty(); }
  bool knows_drift() const { return !drift_unknown && (!failed() || drift_of_mean.se > 0); }
  /// The better known of the two; that of the mean where they disagree by more than four standard errors.
  sdpd::Drift drift() const;
  std::vector<double> histogram() const;
};

/// An equilibrated state of the scene's fluid and size, made with the exact scheme (SSA for DPD) and a short
/// time step.
sdpd::Checkpoint equilibrated_start(Scene const& scene, double dt, double time,
                                    std::function<bool()> const& keep_going);

/// Runs a trial on one thread. Failures of the physics are results. Throws Interrupted.
TrialResult run_trial(Trial const& trial, sdpd::Checkpoint const& start,
                      std::function<bool(std::uint64_t)> const& keep_going);

/// Bins that hold all energies of particles of this state: mean and eight standard deviations. None when they
/// have no energies. `K` is 1 where particles have no sizes.
EnergyBins bins_around(sdpd::Checkpoint const& start, double K);

/// Quadratic distance of two distributions, relative to the second (workflows/README.md, Eq. (W2)).
double distribution_error(std::vector<double> const& found, std::vector<double> const& reference);

/// The part of a trial's distribution error that its finite sample makes: from the difference of its halves.
double distribution_noise(TrialResult const& result, std::vector<double> const& reference);

/// The Gamma law of an ideal-gas particle's energy over the bins (sdpd/README.md, Eq. (S19)).
std::vector<double> gamma_law(double K, EnergyBins const& bins);

} // namespace mesobridge::workflows
