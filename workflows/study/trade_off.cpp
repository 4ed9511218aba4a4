#include "workflows/study/trade_off.hpp"
#include "cg/distribution_error.hpp"
#include "md/error.hpp"
#include "sdpd/observe/gamma_law.hpp"
#include "workflows/study/dynamics.hpp"
#include "workflows/study/rounded_dt.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr double settle = 10;           ///< reduced time after the change to a trial's scheme
constexpr double stability_time = 50;   ///< reduced time that a run has to survive to count as stable
constexpr double stability_limit = 2;   ///< larger time steps are not tried
constexpr double stability_ratio = 1.1; ///< the limit is known to this factor
constexpr double safety = 0.8;          ///< of the stability limit that a recommendation leaves

Scene with(Scene scene, Configuration const& configuration, double dt) {
  scene.particles.K = configuration.K;
  scene.scheme.name = configuration.scheme;
  scene.scheme.splitting = configuration.splitting;
  scene.scheme.conservative = configuration.integrator;
  scene.scheme.dt = {.value = dt, .reduced = true};
  return scene;
}

std::vector<Configuration> configurations(TradeOffPlan const& plan) {
  std::vector<Configuration> all;
  for (double const K : plan.K)
    for (auto const& scheme : plan.schemes)
      for (auto const& splitting : plan.splittings)
        for (auto const& integrator : plan.integrators)
          all.push_back({.scheme = scheme, .splitting = splitting, .integrator = integrator, .K = K});
  return all;
}

/// One short run: does the configuration survive this time step?
bool survives(Scene const& sample, Configuration const& configuration, double dt,
              StudyOptions const& options) {
  Scene scene = with(sample, configuration, dt);
  set_times(scene, dt, 0, stability_time);
  auto const name = fmt::format("stability-{}-dt{:.4g}", configuration.name(), dt);
  return !run_study({{name, scene, std::nullopt}}, options).front().failed();
}

/// What the trials themselves say about stability.
void bound_stability(TradeOffPlan const& plan, Configuration& configuration) {
  for (std::size_t k = 0; k < plan.dt.size(); ++k) {
    double const dt = plan.dt[k];
    auto &stable = configuration.stable_dt, &failing = configuration.failing_dt;
    if (configuration.trials[k].failed())
      failing = std::min(failing.value_or(dt), dt);
    else
      stable = std::max(stable.value_or(dt), dt);
  }
}

/// Bisection between the largest time step that went through and the smallest that failed.
void find_stability_limit(Scene const& sample, StudyOptions const& options, Configuration& configuration) {
  auto &stable = configuration.stable_dt, &failing = configuration.failing_dt;
  constexpr int most_runs = 16;
  for (int run = 0; run < most_runs; ++run) {
    if (stable && failing && *failing < stability_ratio * *stable)
      return;
    double const dt = !failing  ? std::min(1.5 * *stable, stability_limit)
                      : !stable ? *failing / 2
                                : std::sqrt(*stable * *failing);
    if (!failing && *stable >= stability_limit)
      return;
    (survives(sample, configuration, dt, options) ? stable : failing) = dt;
  }
}

/// Of what may also be compared with an exact value, whose error is 0.
cg::Estimate relative(cg::Estimate const& found, cg::Estimate const& reference) {
  double const size = std::abs(reference.mean);
  return {(found.mean - reference.mean) / size, std::hypot(found.se, reference.se) / size,
          std::min(found.n_eff, reference.n_eff)};
}

cg::Estimate bias_of_diffusion(cg::Estimate const& found, cg::Estimate const& reference) {
  return found.se > 0 && reference.se > 0 ? relative(found, reference) : cg::Estimate{};
}

double bound_of(cg::Estimate const& bias) {
  return std::abs(bias.mean) + bias.se;
}

/// c of bias = c dt^2, weighted least squares through the origin.
cg::Estimate quadratic(std::vector<double> const& dt, std::vector<cg::Estimate> const& bias) {
  double top = 0, bottom = 0;
  for (std::size_t k = 0; k < dt.size(); ++k) {
    double const x = dt[k] * dt[k], weight = 1 / (bias[k].se * bias[k].se);
    top += weight * x * bias[k].mean;
    bottom += weight * x * x;
  }
  return {top / bottom, 1 / std::sqrt(bottom), static_cast<double>(dt.size())};
}

struct Limit {
  double dt;
  std::string because;
  void lower(double other, std::string reason) {
    if (other < dt)
      dt = other, because = std::move(reason);
  }
};

constexpr double farthest = 4; ///< a power law is not believed farther below the time steps that were run

/// False when the target cannot be met.
bool limit_by_drift(TradeOff const& found, Configuration const& of, double wanted, Limit& limit) {
  if (double const dt = of.drift.known() ? of.drift.x_surely_below(wanted) : 0; dt > 0) {
    limit.lower(dt, "the wanted energy drift");
    return limit.dt * farthest >= of.drift.x_min;
  }
  double largest = 0; // rates or an exponent that are not resolved: what the rates can be at most
  for (std::size_t k = 0; k < of.trials.size(); ++k) {
    auto const drift = of.trials[k].drift();
    if (!of.trials[k].failed() && of.trials[k].knows_drift() && drift.rate + 2 * drift.se <= wanted)
      largest = std::max(largest, found.plan.dt[k]);
  }
  limit.lower(largest, "the wanted energy drift");
  return largest > 0;
}

void limit_by_bias(TradeOff const& found, Configuration const& of, double wanted, Limit& limit) {
  for (auto const member : {&Bias::T_kin, &Bias::T_int, &Bias::P}) {
    if (member == &Bias::T_int && !found.scene.features().energies)
      continue;
    std::vector<double> dt;
    std::vector<cg::Estimate> bias;
    for (std::size_t k = 0; k < of.trials.size(); ++k)
      if (!of.trials[k].failed()) {
        dt.push_back(found.plan.dt[k]);
        bias.push_back(found.bias(of, of.trials[k]).*member);
      }
    limit.lower(std::sqrt(wanted / bound_of(quadratic(dt, bias))), "the wanted bias");
  }
}

/// Of temperatures that rise by the energy's drift over the scene's own steps, where nothing takes it out; a
/// drift whose law is not known limits nothing. False when the target cannot be met.
bool limit_by_heating(TradeOff const& found, Configuration const& of, double wanted, std::string const& what,
                      Limit& limit) {
  if (!of.drift.known())
    return true;
  auto const& trial = *std::ranges::find_if(of.trials, [](auto const& one) { return !one.failed(); });
  auto heating = of.drift; // rate times dt
  heating.exponent.mean += 1;
  double const K = of.K > 0 ? of.K : 1; // k_B is 1/K, and 1 without sizes
  double const share = wanted * trial.heat_capacity / (K * std::abs(trial.E_0)); // of the energy
  if (!(share > 0 && std::isfinite(share)))
    return true;
  double const dt = heating.x_surely_below(share / static_cast<double>(found.scene.run.steps));
  if (!(dt > 0))
    return true;
  limit.lower(dt, what + " over the run's length");
  return dt * farthest >= of.drift.x_min;
}

} // namespace

std::string Configuration::name() const {
  return (K > 0 ? fmt::format("K{:g}-", K) : "") + fmt::format("{}-{}-{}", scheme, splitting, integrator);
}

double Bias::bound() const {
  return std::max({bound_of(T_kin), bound_of(T_int), bound_of(P)});
}

sdpd::TrialResult const& TradeOff::reference(double K) const {
  sdpd::TrialResult const* best = nullptr;
  bool best_is_exact = false;
  for (auto const& configuration : configurations)
    for (auto const& trial : configuration.trials) {
      bool const exact = configuration.scheme == "ems";
      if (configuration.K != K || trial.failed())
        continue;
      if (!best || (exact && !best_is_exact) || (exact == best_is_exact && trial.dt < best->dt))
        best = &trial, best_is_exact = exact;
    }
  if (!best)
    throw PhysicsError(fmt::format("no run{} went through: take shorter time steps",
                                   K > 0 ? fmt::format(" at K = {:g}", K) : ""));
  return *best;
}

Bias TradeOff::bias(Configuration const& of, sdpd::TrialResult const& trial) const {
  auto const& exact = reference(of.K);
  if (!scene.features().energies)
    return {.T_kin = relative(trial.T_kin, {1, 0, trial.T_kin.n_eff}),
            .P = relative(trial.P, exact.P),
            .D = bias_of_diffusion(trial.D, exact.D)};
  Bias bias{.T_kin = relative(trial.T_kin, exact.T_kin),
            .T_int = relative(trial.T_int, exact.T_int),
            .P = relative(trial.P, exact.P),
            .D = bias_of_diffusion(trial.D, exact.D),
            .eps_variance = relative(trial.eps_variance, exact.eps_variance)};
  auto histogram = exact.histogram();
  if (scene.fluid.eos == "ideal-gas") {
    double const shape = 1.5 * (of.K - 1);
    bias.eps_variance = relative(trial.eps_variance, {shape, 0, trial.eps_variance.n_eff});
    histogram = sdpd::gamma_law(of.K, trial.bins);
  }
  bias.distribution = cg::distribution_error(trial.histogram(), histogram);
  bias.distribution_noise = cg::distribution_noise(trial.first_half, trial.second_half, histogram);
  return bias;
}

std::vector<PlannedTrial> planned_trials(Scene const& scene, TradeOffPlan const& plan) {
  auto const sample = small_sample(scene, plan.particles);
  std::vector<PlannedTrial> trials;
  for (auto const& configuration : configurations(plan))
    for (double const dt : plan.dt) {
      Scene trial = with(sample, configuration, dt);
      set_times(trial, dt, settle, plan.time);
      trials.push_back({fmt::format("{}-dt{:g}", configuration.name(), dt), trial, std::nullopt});
    }
  return trials;
}

TradeOff trade_off(Scene const& scene, TradeOffPlan const& plan, StudyOptions const& options) {
  auto const sample = small_sample(scene, plan.particles);
  TradeOff found{.scene = sample, .plan = plan, .configurations = configurations(plan)};
  auto const results = run_study(planned_trials(scene, plan), options);
  auto result = results.begin();
  for (auto& configuration : found.configurations) {
    std::vector<double> dt;
    std::vector<cg::Estimate> rates;
    for (double const step : plan.dt) {
      configuration.trials.push_back(*result++);
      auto const& trial = configuration.trials.back();
      if (trial.failed() || !trial.knows_drift())
        continue;
      dt.push_back(step);
      rates.push_back({trial.drift().rate, trial.drift().se, 8});
    }
    configuration.drift = fitting::fit_power_law(dt, rates);
  }
  for (auto& configuration : found.configurations) {
    bound_stability(plan, configuration);
    if (plan.stability_limit)
      find_stability_limit(sample, options, configuration);
  }
  return found;
}

std::optional<Recommendation> largest_dt(TradeOff const& found, std::size_t index, Target const& target) {
  auto const& of = found.configurations[index];
  std::optional<std::size_t> largest;
  for (std::size_t k = 0; k < of.trials.size(); ++k)
    if (!of.trials[k].failed() && (!largest || found.plan.dt[k] > found.plan.dt[*largest]))
      largest = k;
  if (!largest)
    return std::nullopt;
  Limit limit{found.plan.dt[*largest], "the largest time step that was run"};
  if (of.failing_dt)
    limit.lower(safety * *of.failing_dt, "stability");
  if (target.drift && !limit_by_drift(found, of, *target.drift, limit))
    return std::nullopt;
  if (target.bias) {
    limit_by_bias(found, of, *target.bias, limit);
    if (!limit_by_heating(found, of, *target.bias, "the wanted bias", limit))
      return std::nullopt;
  }
  if (target.dynamics) {
    limit.lower(largest_dynamic_dt(found, of, *target.dynamics), "the wanted dynamics");
    if (!limit_by_heating(found, of, *target.dynamics, "the wanted dynamics", limit)) // D goes as T
      return std::nullopt;
  }
  double const dt = rounded_down(limit.dt);
  return Recommendation{.configuration = index,
                        .dt = dt,
                        .us_per_particle_time = of.trials[*largest].us_per_particle_step / dt,
                        .because = limit.because};
}

std::optional<Recommendation> recommend(TradeOff const& found, double K, Target const& target) {
  std::optional<Recommendation> best;
  for (std::size_t index = 0; index < found.configurations.size(); ++index) {
    if (found.configurations[index].K != K)
      continue;
    auto const choice = largest_dt(found, index, target);
    if (choice && (!best || choice->us_per_particle_time < best->us_per_particle_time))
      best = choice;
  }
  return best;
}

} // namespace mesobridge::workflows
