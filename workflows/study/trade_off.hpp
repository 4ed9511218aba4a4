#pragma once
#include "fitting/power_law.hpp"
#include "workflows/study/study.hpp"

namespace mesobridge::workflows {

/// What is varied.
struct TradeOffPlan {
  std::vector<std::string> schemes, splittings, integrators;
  std::vector<double> dt;       ///< reduced
  std::vector<double> K;        ///< of SDPD; 0 for others, which have no sizes
  double time = 256;            ///< reduced, sampled by each trial
  std::int64_t particles = 343; ///< of a trial, at least
  bool stability_limit = true;  ///< find the largest stable time step of every configuration
};

/// A tolerance: energy drift of (E - E_0)/|E_0| per reduced unit of time, relative bias of T_kin, T_int and
/// P, or excess of the self-diffusion.
struct Target {
  std::optional<double> drift, bias, dynamics;

  bool any() const { return drift || bias || dynamics; }
};

/// One scheme, splitting, integrator and size over all time steps.
struct Configuration {
  std::string scheme, splitting, integrator;
  double K = 0;
  std::vector<sdpd::TrialResult> trials; ///< in the order of the plan's dt
  fitting::PowerLaw drift;               ///< of the rates against dt
  std::optional<double> stable_dt;       ///< the largest time step at which a run went through
  std::optional<double> failing_dt; ///< the smallest one at which none did; nothing up to the search's limit

  std::string name() const;
};

/// Deviation of a trial from the reference of its size, relative; what the method does not have is 0. T_kin
/// of DPD is compared with the set temperature, which its thermostat keeps.
struct Bias {
  cg::Estimate T_kin, T_int, P;
  cg::Estimate D; ///< se = 0: one of the two is not known
  cg::Estimate eps_variance;
  double distribution = 0,
         distribution_noise = 0; ///< cg/README.md, Eq. (C16), and what the sample's noise makes of it
  /// The largest of those of T_kin, T_int, P that one standard error allows.
  double bound() const;
};

struct TradeOff {
  Scene scene; ///< the sample that was run, at the last of its K
  TradeOffPlan plan;
  std::vector<Configuration> configurations;
  /// The trial that the others of its size are compared with: smallest time step, exact scheme if it is
  /// there.
  sdpd::TrialResult const& reference(double K) const;
  Bias bias(Configuration const& of, sdpd::TrialResult const& trial) const;
};

/// The choice for a target.
struct Recommendation {
  std::size_t configuration = 0;
  double dt = 0;
  double us_per_particle_time = 0; ///< processor time per particle and reduced unit of time
  std::string because;             ///< what limits dt: the drift, the bias, stability, the largest dt tried
};

/// The trials of a plan, of samples of the scene.
std::vector<PlannedTrial> planned_trials(Scene const& scene, TradeOffPlan const& plan);

/// Runs all trials. `directory` holds those that are stored.
TradeOff trade_off(Scene const& scene, TradeOffPlan const& plan, StudyOptions const& options);

/// The cheapest configuration of size K that meets the target, with its largest time step; nothing when none
/// does.
std::optional<Recommendation> recommend(TradeOff const& found, double K, Target const& target);

/// The largest time step of one configuration that meets the target, and why no larger one; nothing when none
/// does.
std::optional<Recommendation> largest_dt(TradeOff const& found, std::size_t configuration,
                                         Target const& target);

} // namespace mesobridge::workflows
