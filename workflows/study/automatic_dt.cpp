#include "workflows/study/automatic_dt.hpp"
#include "md/error.hpp"
#include "workflows/scene/tolerance.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/study/driven_dt.hpp"
#include "workflows/study/dynamics.hpp"
#include "workflows/study/rounded_dt.hpp"
#include "workflows/study/target.hpp"
#include "workflows/study/tries.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

Scene with_time_step(Scene scene, TimeStep const& dt) {
  scene.scheme.dt_chosen_for = tolerance_text(scene.scheme);
  scene.scheme.drift = scene.scheme.bias = scene.scheme.dynamics = std::nullopt;
  scene.scheme.dt = dt;
  return scene;
}

/// The scene that the study varies.
Scene trial_of(Scene const& scene) {
  Scene trial = with_time_step(scene, {.value = 1});
  trial.scheme.dt_chosen_for = std::nullopt;
  return trial;
}

/// Whether a tolerance is of the fluid at rest.
bool wants_quiet_trials(Scene const& scene) {
  return (scene.scheme.drift && !balance_tolerance(scene.scheme)) || scene.scheme.bias ||
         scene.scheme.dynamics;
}

/// The usual tries and, for the dynamics, the shorter step that surely keeps them, if it is not far shorter.
std::vector<double> steps_of_trials(Scene const& scene) {
  constexpr double farthest = 6;
  auto dt = tries_of(scene).dt;
  if (!scene.scheme.dynamics)
    return dt;
  double const sure =
      rounded_down(std::min(dt.front(), dt_by_bound(trial_of(scene), parse_share(*scene.scheme.dynamics))));
  if (sure < dt.front() && farthest * sure > dt.front())
    dt.insert(dt.begin(), sure);
  return dt;
}

TradeOffPlan plan_of(Scene const& scene) {
  auto const tries = tries_of(scene);
  return {.schemes = {scene.scheme.name},
          .splittings = {scene.scheme.splitting},
          .integrators = {scene.scheme.conservative},
          .dt = steps_of_trials(scene),
          .K = {scene.particles.K},
          .time = tries.time,
          .stability_limit = false};
}

} // namespace

double largest_tried_dt(Scene const& scene) {
  return wants_quiet_trials(scene) ? tries_of(scene).dt.back() : largest_driven_dt(scene);
}

std::vector<PlannedTrial> time_step_trials(Scene const& scene) {
  if (!wants_quiet_trials(scene))
    return {};
  return planned_trials(trial_of(scene), plan_of(scene));
}

namespace {

/// What the fluid at rest lets one take.
struct Choice {
  double dt;
  std::string because;
  sdpd::DiffusionAgainstStep diffusion = {}; ///< where the scene tolerates a change of its dynamics
};

Choice choose_at_rest(Scene const& scene, StudyOptions const& options) {
  Scene const trial = trial_of(scene);
  auto const plan = plan_of(scene);
  auto const rate = balance_tolerance(scene.scheme) ? std::nullopt : scene.scheme.drift;
  auto const target = parse_target(rate, scene.scheme.bias, scene.scheme.dynamics, scene.units,
                                   settings_of(trial, 1).units().time());
  auto const found = trade_off(trial, plan, options);
  auto const choice = largest_dt(found, 0, target);
  if (!choice)
    throw PhysicsError(
        fmt::format("scheme.dt = \"auto\": no time step of {} to {} meets {} with {}; allow "
                    "more, or take another scheme or integrator (`mesobridge trade-off` compares them)",
                    plan.dt.front(), plan.dt.back(), tolerance_text(scene.scheme), scene.scheme.name));
  return {choice->dt, choice->because,
          target.dynamics ? diffusion_against_step(found, found.configurations.front())
                          : sdpd::DiffusionAgainstStep{}};
}

/// What the trials say of the excess of the diffusion, in words.
std::string words_of(Scene const& scene, Choice const& choice) {
  if (!scene.scheme.dynamics)
    return "";
  double const bound = 100 * excess_by_bound(trial_of(scene), choice.dt);
  auto const& [D_0, share] = choice.diffusion;
  if (!choice.diffusion.known())
    return fmt::format("; it makes self-diffusion too large by {:.2g} % at most, trials did not tell more",
                       bound);
  return fmt::format("; trials show that it changes self-diffusion by {:.2g} ± {:.1g} %", bound * share.mean,
                     bound * share.se);
}

} // namespace

ChosenTimeStep choose_time_step(Scene const& scene, StudyOptions const& options) {
  Choice choice{largest_tried_dt(scene), "the largest time step that was run"};
  if (wants_quiet_trials(scene))
    choice = choose_at_rest(scene, options);
  if (balance_tolerance(scene.scheme)) {
    auto const driven =
        find_balanced_time_step(scene, std::min(choice.dt, largest_driven_dt(scene)), options);
    choice.dt = driven.dt;
    if (!driven.longest)
      choice.because = "the wanted energy balance";
  }
  Scene chosen = with_time_step(scene, {.value = choice.dt});
  if (choice.diffusion.known()) {
    chosen.scheme.diffusion_share = choice.diffusion.share.mean;
    chosen.scheme.diffusion_share_se = choice.diffusion.share.se;
  }
  return {chosen, fmt::format("dt = {:g} reduced, chosen for {}; limited by {}{}", choice.dt,
                              tolerance_text(scene.scheme), choice.because, words_of(scene, choice))};
}

Scene with_stored_time_step(Scene const& scene, Scene const& stored) {
  auto const tolerance = tolerance_text(scene.scheme);
  require(stored.scheme.dt_chosen_for == tolerance, "the time step of the checkpoint",
          stored.scheme.dt_chosen_for.value_or("(given)"),
          fmt::format("must have been chosen for {}, which the scene asks for", tolerance));
  Scene with = with_time_step(scene, stored.scheme.dt);
  with.scheme.diffusion_share = stored.scheme.diffusion_share;
  with.scheme.diffusion_share_se = stored.scheme.diffusion_share_se;
  return with;
}

} // namespace mesobridge::workflows
