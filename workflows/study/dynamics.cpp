#include "workflows/study/dynamics.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// How fast friction makes velocities forget, whatever the time step.
double decay_rate(Scene scene) {
  scene.scheme.dt = {.value = 1, .reduced = true};
  return sdpd::velocity_decay_rate(settings_of(scene, 1));
}

Scene of_size(Scene scene, double K) {
  scene.particles.K = K;
  return scene;
}

} // namespace

double dt_by_bound(Scene const& scene, double share) {
  return sdpd::step_of_diffusion_excess(decay_rate(scene), share) /
         static_cast<double>(scene.scheme.fluctuate_every);
}

double excess_by_bound(Scene const& scene, double dt) {
  return sdpd::diffusion_excess(decay_rate(scene), dt * static_cast<double>(scene.scheme.fluctuate_every));
}

sdpd::DiffusionAgainstStep diffusion_against_step(TradeOff const& found, Configuration const& of) {
  Scene const scene = of_size(found.scene, of.K);
  auto trials = of.trials;
  std::ranges::sort(trials, {}, &sdpd::TrialResult::dt);
  std::vector<double> excess;
  std::vector<cg::Estimate> D;
  for (auto const& trial : trials)
    if (!trial.failed()) {
      excess.push_back(excess_by_bound(scene, trial.dt));
      D.push_back(trial.D);
    }
  return sdpd::diffusion_against_step(excess, D);
}

double largest_dynamic_dt(TradeOff const& found, Configuration const& of, double share) {
  return dt_by_bound(of_size(found.scene, of.K), share / diffusion_against_step(found, of).at_most());
}

} // namespace mesobridge::workflows
