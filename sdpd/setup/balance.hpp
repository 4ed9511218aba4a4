#pragma once
#include "sdpd/simulation.hpp"
#include <functional>
#include <string>

namespace mesobridge::sdpd {

/// The beginning of a run that something drives, to see how well a time step balances its energy.
struct BalanceTrial {
  SimulationSettings settings;
  std::int64_t steps = 0;     ///< that are made, > 0
  std::int64_t run_steps = 0; ///< of the whole run, >= steps
};

/// The energy of such a beginning at some instants, from its start on; reduced.
struct BalanceSeries {
  std::vector<double> times;
  std::vector<double> errors;    ///< E - E_0 - what has come from outside (Observation::given)
  std::vector<double> given;     ///< from outside so far
  std::vector<double> exchanged; ///< gain of the internal energies so far
};

/// What a trial has found. One that failed has its reason, and the energies until then.
struct BalanceResult {
  std::string failure; ///< empty: it went through
  double dt = 0;
  double share = 0;     ///< of error_share at the end of the trial
  double run_share = 0; ///< the same at the end of the run, by extrapolation
  double us_per_particle_step = 0;

  bool failed() const { return !failure.empty(); }
};

/// The largest error so far over the larger of what has come from outside and what internal and kinetic
/// energies have exchanged (sdpd/README.md, Eq. (S73)); 0 where nothing has.
double error_share(BalanceSeries const& series);

/// The same at a later time: the error goes on as a t + b t^2 fitted to it, between linear and quadratic
/// growth of its largest value; what comes from outside grows linearly, what is exchanged not at all.
double error_share_at(BalanceSeries const& series, double time);

/// Runs a trial from a state at rest (equilibrated_start). Failures of the physics are results. Throws
/// Interrupted when `keep_going`, which is told the steps done, says no.
BalanceResult run_balance_trial(BalanceTrial const& trial, Checkpoint const& start,
                                std::function<bool(std::int64_t)> const& keep_going);

} // namespace mesobridge::sdpd
