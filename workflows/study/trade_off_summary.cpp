#include "workflows/study/trade_off_summary.hpp"
#include "workflows/study/dynamics.hpp"
#include "workflows/study/trade_off_parts.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {
namespace {

Json trial_json(TradeOff const& found, Configuration const& of, sdpd::TrialResult const& trial, double dt) {
  auto const units = units_of(found, of.K);
  std::string const per = units.si ? "_per_ps" : "_per_time";
  Json json{{"dt_reduced", dt}, {"dt" + std::string(units.si ? "_ps" : ""), dt * units.ps}};
  if (trial.failed()) {
    json["failure"] = trial.failure;
    return json;
  }
  auto const bias = found.bias(of, trial);
  json["us_per_particle_step"] = trial.us_per_particle_step;
  json["us_per_particle" + std::string(units.si ? "_ps" : "_time")] =
      trial.us_per_particle_step / (dt * units.ps);
  bool const energies = found.scene.features().energies;
  if (energies) {
    put(json, "energy_drift" + per, estimate(trial.drift(), units.ps));
    put(json, "energy_drift_of_mean" + per, estimate(trial.drift_of_mean, units.ps));
  }
  if (trial.drift_of_walk.se > 0)
    put(json, "energy_drift_of_walk" + per, estimate(trial.drift_of_walk, units.ps));
  put(json, "T_kin" + units.units.temperature_key,
      {trial.T_kin.mean * units.units.temperature, trial.T_kin.se * units.units.temperature,
       trial.T_kin.n_eff});
  if (energies)
    put(json, "T_int" + units.units.temperature_key,
        {trial.T_int.mean * units.units.temperature, trial.T_int.se * units.units.temperature,
         trial.T_int.n_eff});
  put(json, "P" + units.units.pressure_key,
      {trial.P.mean * units.units.pressure, trial.P.se * units.units.pressure, trial.P.n_eff});
  put(json, "bias_T_kin", bias.T_kin), put(json, "bias_P", bias.P);
  auto const& [time, length] = std::tie(units.units.time, units.units.length);
  if (trial.D.se > 0)
    put(json, units.si ? "D_m2_per_s" : "D", scaled(trial.D, length * length / time));
  if (bias.D.se > 0)
    put(json, "bias_D", bias.D);
  if (energies) {
    put(json, "bias_T_int", bias.T_int), put(json, "bias_eps_variance", bias.eps_variance);
    json["eps_distribution_error"] = bias.distribution;
    json["eps_distribution_noise"] = bias.distribution_noise;
  }
  json["rejected_out_of_domain"] = trial.rejected_out_of_domain;
  json["rejected_metropolis"] = trial.rejected_metropolis;
  return json;
}

} // namespace

SizeUnits units_of(TradeOff const& found, double K) {
  Scene scene = found.scene;
  scene.particles.K = K;
  bool const si = scene.units == UnitSystem::SI;
  OutputUnits const units(settings_of(scene, 1).units(), scene.units);
  return {units, si, units.time * (si ? 1e12 : 1)};
}

std::string time_name(SizeUnits const& units) {
  return units.si ? "ps" : "LJ time";
}

cg::Estimate estimate(sdpd::Drift const& drift, double unit) {
  return {drift.rate / unit, drift.se / unit, 8};
}

std::string short_name(Configuration const& of) {
  return fmt::format("{}{}{}{}", of.scheme, of.splitting == "lie-trotter" ? "" : ", " + of.splitting,
                     of.integrator == "verlet" ? "" : ", " + of.integrator, "");
}

std::set<double> sizes(TradeOff const& found) {
  return {found.plan.K.begin(), found.plan.K.end()};
}

std::string size_text(double K) {
  return K > 0 ? fmt::format("K = {:g}: ", K) : "";
}

std::string target_text(Target const& target) {
  std::vector<std::string> parts;
  if (target.drift)
    parts.push_back(fmt::format("energy drift {:.3g} per reduced unit of time", *target.drift));
  if (target.bias)
    parts.push_back(fmt::format("bias of T_kin, T_int and P {:.3g} %", 100 * *target.bias));
  if (target.dynamics)
    parts.push_back(fmt::format("self-diffusion within {:.3g} %", 100 * *target.dynamics));
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string settings_text(TradeOff const& found, double K, Recommendation const& choice) {
  auto const& of = found.configurations[choice.configuration];
  // Three digits, rounded down: a longer step was not recommended.
  double const unit = std::pow(10, std::floor(std::log10(choice.dt)) - 2);
  double const dt = std::floor(choice.dt / unit * (1 + 1e-12)) * unit;
  auto text = fmt::format("--set scheme.name={} --set scheme.splitting={} --set scheme.conservative={} "
                          "--set scheme.dt={:.3g}",
                          of.scheme, of.splitting, of.integrator, dt);
  return K > 0 ? text + fmt::format(" --set particles.K={:g}", K) : text;
}

std::string recommendation_text(TradeOff const& found, Target const& target) {
  std::string text;
  for (double const K : sizes(found)) {
    auto const choice = recommend(found, K, target);
    if (!choice) {
      text += size_text(K) + "no scheme that was tried meets this target\n";
      continue;
    }
    auto const units = units_of(found, K);
    text += fmt::format(
        "{}{}, dt = {:.2g} reduced ({:.3g} {}), {:.3g} us per particle and {}; limited by {}\n", size_text(K),
        short_name(found.configurations[choice->configuration]), choice->dt, choice->dt * units.ps,
        time_name(units), choice->us_per_particle_time / units.ps, time_name(units), choice->because);
    text += fmt::format("  apply it with: {}\n", settings_text(found, K, *choice));
  }
  return text;
}

Json trade_off_json(TradeOff const& found, Target const& target) {
  Json json;
  for (auto const& of : found.configurations) {
    Json one{{"scheme", of.scheme}, {"splitting", of.splitting}, {"conservative", of.integrator}};
    if (of.K > 0)
      one["K"] = of.K;
    if (of.stable_dt)
      one["largest_stable_dt_reduced"] = *of.stable_dt;
    if (of.failing_dt)
      one["smallest_failing_dt_reduced"] = *of.failing_dt;
    if (of.drift.known())
      put(one, "drift_exponent", of.drift.exponent);
    if (auto const motion = diffusion_against_step(found, of); motion.known())
      put(one, "diffusion_excess_share", motion.share);
    for (std::size_t k = 0; k < of.trials.size(); ++k)
      one["trials"].push_back(trial_json(found, of, of.trials[k], found.plan.dt[k]));
    json["configurations"].push_back(one);
  }
  if (!target.any())
    return json;
  json["target"] = target_text(target);
  for (double const K : sizes(found)) {
    auto const choice = recommend(found, K, target);
    if (!choice)
      continue;
    auto const& of = found.configurations[choice->configuration];
    Json one{{"scheme", of.scheme},
             {"splitting", of.splitting},
             {"conservative", of.integrator},
             {"dt_reduced", choice->dt},
             {"us_per_particle_reduced_time", choice->us_per_particle_time},
             {"limited_by", choice->because},
             {"set", settings_text(found, K, *choice)}};
    if (K > 0)
      one["K"] = K;
    json["recommended"].push_back(std::move(one));
  }
  return json;
}

} // namespace mesobridge::workflows
