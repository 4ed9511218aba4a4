#include "workflows/study/driven_dt.hpp"
#include "fitting/eos/evaluate.hpp"
#include "md/error.hpp"
#include "sdpd/setup/balance.hpp"
#include "workflows/scene/tolerance.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/scene_inputs.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/study/rounded_dt.hpp"
#include "workflows/study/stored_part.hpp"
#include "workflows/study/tries.hpp"
#include "workflows/version.hpp"
#include <algorithm>

namespace mesobridge::workflows {

template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, sdpd::BalanceResult>
void for_each_member(Result& r, F const& f) {
  f("failure", r.failure), f("dt", r.dt), f("share", r.share), f("run_share", r.run_share);
  f("us_per_particle_step", r.us_per_particle_step);
}

namespace {

constexpr double part_of_run = 0.2;     ///< that a trial makes
constexpr double crossed = 20;          ///< spacings that what is fastest crosses in a trial
constexpr double part_of_spacing = 0.5; ///< that it may cross in the longest step
constexpr double deepest = 1e-3;        ///< of the largest time step: the search ends there
constexpr int most_trials = 12;
constexpr double start_time = 20; ///< reduced time to equilibrium before the trials

double largest_component(std::vector<double> const& v) {
  double found = 0;
  for (double const component : v)
    found = std::max(found, std::abs(component));
  return found;
}

/// The velocities that the piston has at its fastest, into the fluid and away from it, >= 0.
std::pair<double, double> fastest_piston(sdpd::SimulationSettings const& settings) {
  double in = 0, out = 0;
  for (auto const& [lower, upper] : settings.faces) {
    in = std::max(in, lower.motion.velocity), out = std::max(out, -lower.motion.velocity);
    for (auto const& row : lower.motion.table)
      in = std::max(in, row.velocity), out = std::max(out, -row.velocity);
  }
  return {in, out};
}

/// The velocity of the shock that a piston makes that keeps this velocity; 0 where there is none, or no
/// equation of state that could tell.
double shock_velocity(sdpd::SimulationSettings const& settings, double v_P) {
  if (auto const shock = shock_before_piston(settings)) // which knows what a reaction does
    return shock->v_S;
  try {
    auto const shock = v_P > 0 ? piston_shock(settings, v_P) : std::nullopt;
    return shock ? shock->v_S : 0;
  } catch (PhysicsError const&) {
    return 0;
  }
}

/// The fastest motion that the scene names, and the shock that it makes where the equation of state tells it;
/// at least the thermal velocity. Reduced.
double fastest_motion(Scene const& scene, sdpd::SimulationSettings const& settings) {
  auto const units = settings.units();
  auto const [in, out] = fastest_piston(settings);
  double named = std::max({in, out, std::abs(scene.box.slide.value_or(0)), shock_velocity(settings, in)});
  for (auto const& region : scene.regions)
    named = std::max(named, largest_component(region.velocity));
  return std::max(1 / std::sqrt(units.K), named / units.velocity());
}

/// The faster of that and the sound in the fluid at rest.
double fastest_wave(Scene const& scene, sdpd::SimulationSettings const& settings) {
  double velocity = fastest_motion(scene, settings);
  if (scene.features().densities) {
    auto const c2 = std::visit(
        [&](auto const& eos) {
          return fitting::state_from_temperature(eos, settings.rho, settings.T).sound_speed_squared;
        },
        settings.as<sdpd::Sdpd>().eos);
    velocity = std::max(velocity, std::sqrt(std::max(0.0, c2)) / settings.units().velocity());
  }
  return velocity;
}

/// The scene's own run with that time step.
sdpd::SimulationSettings settings_with(Scene const& scene, double dt, int threads) {
  Scene trial = scene;
  trial.scheme.dt = {.value = dt};
  return settings_of(trial, threads);
}

std::int64_t steps_of_trial(Scene const& scene, double dt, double velocity) {
  auto const run = scene.run.steps;
  auto const share = static_cast<std::int64_t>(std::ceil(part_of_run * static_cast<double>(run)));
  auto const way = static_cast<std::int64_t>(std::ceil(std::min(crossed / (velocity * dt), 1e12)));
  return std::min(run, std::max(share, way));
}

double start_time_of(Scene const& scene) {
  return scene.run.equilibrate > 0 ? start_time : 0;
}

/// Nothing drives the fluid yet.
double start_dt(Scene const& scene) {
  constexpr double of_fluids = 0.05;
  return of_fluids / tries_of(scene).shorter_start;
}

/// The next time step after one that failed or missed more than it may: the error goes as its square.
double next_dt(sdpd::BalanceResult const& trial, double tolerance) {
  double const factor =
      trial.failed() ? 0.5 : std::clamp(0.9 * std::sqrt(tolerance / trial.run_share), 0.25, 0.8);
  return rounded_down(trial.dt * factor);
}

/// The search on its way.
class Search {
 public:
  Search(Scene const& scene, double largest, StudyOptions const& options)
      : scene_(scene), options_(options), largest_(rounded_down(largest)),
        tolerance_(balance_tolerance(scene.scheme).value()),
        velocity_(fastest_wave(scene, settings_with(scene, largest_, 1))) {}

  BalancedTimeStep find() {
    sdpd::BalanceResult last;
    double dt = largest_;
    for (int k = 0; k < most_trials && dt >= deepest * largest_; ++k) {
      last = trial(dt, k);
      if (!last.failed() && last.run_share <= tolerance_)
        return {dt, last.run_share, k == 0};
      dt = next_dt(last, tolerance_);
    }
    throw PhysicsError(fmt::format(
        "scheme.dt = \"auto\": no time step of {} to {} balances the energy within {}; at {} {}; allow "
        "more, or take another scheme or integrator",
        last.dt, largest_, *scene_.scheme.drift, last.dt,
        last.failed() ? fmt::format("a trial fails: {}", last.failure)
                      : fmt::format("a trial lets expect {:.2g} %", 100 * last.run_share)));
  }

 private:
  sdpd::BalanceResult trial(double dt, int k) {
    auto const name = fmt::format("balance-dt{:g}", dt);
    auto const made_of = fmt::format("{}\n{}{}\nlargest {}", resolved_toml(scene_), git_commit(),
                                     input_hashes(scene_), largest_);
    auto const make = [&] { return run(dt, k, name); };
    return options_.directory.empty() ? make()
                                      : stored_or_made(options_.directory / (name + ".json"), made_of, make);
  }

  sdpd::BalanceResult run(double dt, int k, std::string const& name) {
    auto const steps = steps_of_trial(scene_, dt, velocity_);
    auto const told = [&](double share) { return options_.keep_going((k + share) / most_trials, name); };
    return sdpd::run_balance_trial(
        {.settings = settings_with(scene_, dt, options_.threads),
         .steps = steps,
         .run_steps = scene_.run.steps},
        start(), [&](std::int64_t done) { return told(static_cast<double>(done) / double(steps)); });
  }

  sdpd::Checkpoint const& start() {
    if (!start_)
      start_ =
          sdpd::equilibrated_start(settings_with(scene_, largest_, options_.threads), start_dt(scene_),
                                   start_time_of(scene_), [&] { return options_.keep_going(0, "start"); });
    return *start_;
  }

  Scene const& scene_;
  StudyOptions const& options_;
  double largest_, tolerance_, velocity_;
  std::optional<sdpd::Checkpoint> start_;
};

} // namespace

double largest_driven_dt(Scene const& scene) {
  double const longest = tries_of(scene).dt.back();
  auto const settings = settings_with(scene, longest, 1);
  return std::min(longest, part_of_spacing * settings.spacing() / fastest_motion(scene, settings));
}

BalancedTimeStep find_balanced_time_step(Scene const& scene, double largest, StudyOptions const& options) {
  return Search(scene, largest, options).find();
}

double work_of_balance_trials(Scene const& scene) {
  if (!balance_tolerance(scene.scheme))
    return 0;
  constexpr double usual_trials = 3;
  double const dt = largest_driven_dt(scene);
  double const velocity = fastest_wave(scene, settings_with(scene, dt, 1));
  return static_cast<double>(particles_of(scene)) *
         (usual_trials * static_cast<double>(steps_of_trial(scene, dt, velocity)) +
          start_time_of(scene) / start_dt(scene));
}

} // namespace mesobridge::workflows
