#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "md/error.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {
namespace {

std::string viscosity_unit(UnitSystem system) {
  return system == UnitSystem::SI ? " Pa s" : "";
}

std::string viscosity_key(UnitSystem system) {
  return system == UnitSystem::SI ? "_Pa_s" : "";
}

/// Refusals name the keys that ask for what is refused, first that of the viscosity.
template <class Make>
auto with_asking_keys(Scene const& scene, Make const& make) {
  auto const asked = fmt::format("transport.eta = {:g}{}, eta_means = \"realised\"", scene.transport.eta,
                                 viscosity_unit(scene.units));
  try {
    return make();
  } catch (InputError const& error) {
    throw InputError(fmt::format("{}: {}; "
                                 "eta_means = \"pair\" leaves it to the pairs alone",
                                 asked, error.what()));
  } catch (PhysicsError const& error) {
    throw PhysicsError(fmt::format("{}: in trials of the viscosity {}", asked, error.what()));
  }
}

} // namespace

bool wants_trials_of_viscosity(Scene const& scene) {
  return scene.features().densities && scene.transport.eta_means == "realised" && !scene.transport.eta_pairs;
}

sdpd::SimulationSettings settings_of_viscosity_trials(Scene const& scene, int threads) {
  auto fluid = fluid_alone(scene);
  fluid.box = {};
  fluid.transport.eta_pairs = std::nullopt;
  auto const lattice = sdpd::viscosity_lattice(settings_of(fluid, threads));
  fluid.particles.N = std::int64_t{1} * lattice[0] * lattice[1] * lattice[2];
  return settings_of(fluid, threads);
}

void check_viscosity_trials(Scene const& scene) {
  with_asking_keys(scene, [&] { sdpd::check_realised_viscosity(settings_of_viscosity_trials(scene, 1)); });
}

sdpd::RealisedViscosity find_viscosity_of_pairs(Scene const& scene, int threads,
                                                std::function<bool()> const& keep_going,
                                                std::function<void(std::string const&)> const& tell) {
  int number = 0;
  auto const tell_trial = [&](sdpd::ViscosityTrial const& trial) {
    if (tell)
      tell(fmt::format("trial {} of the viscosity: waves have {}{} with {}{} of the pairs", ++number,
                       with_error_text(trial.realised), viscosity_unit(scene.units),
                       number_text(trial.pairs, 4), viscosity_unit(scene.units)));
  };
  return with_asking_keys(scene, [&] {
    return sdpd::realise_viscosity(settings_of_viscosity_trials(scene, threads), keep_going, tell_trial);
  });
}

Json viscosity_trials_json(sdpd::RealisedViscosity const& found, Scene const& scene) {
  auto const unit = viscosity_key(scene.units);
  Json json;
  json["eta_asked" + unit] = scene.transport.eta;
  json["eta_pairs" + unit] = found.pairs;
  put(json, "eta_realised" + unit, found.realised);
  json["wavelength_spacings"] = found.wavelength;
  put(json, "eta_of_half_the_wavelength" + unit, found.of_half_wave);
  json["eta_kinetic_mean_field" + unit] = found.kinetic;
  json["amplitude_over_thermal_velocity"] = found.amplitude;
  put(json, "T_kin_over_T", found.T_kin);
  json["particles"] = found.particles;
  json["steps"] = found.steps;
  for (auto const& trial : found.trials) {
    Json one{{"eta_pairs" + unit, trial.pairs}};
    put(one, "eta_realised" + unit, trial.realised);
    json["trials"].push_back(one);
  }
  return json;
}

void put_viscosities(Json& summary, Scene const& scene, Json const& trials) {
  if (!scene.transport.eta_pairs)
    return;
  auto const unit = viscosity_key(scene.units);
  summary["eta_asked" + unit] = scene.transport.eta;
  summary["eta_pairs" + unit] = *scene.transport.eta_pairs;
  if (!trials.is_object())
    return;
  for (auto const& name : {"eta_realised" + unit, "eta_realised" + unit + "_se"})
    summary[name] = trials.at(name);
  summary["viscosity_trials"] = trials;
}

std::string viscosities_text(Scene const& scene, Json const& summary) {
  auto const unit = viscosity_unit(scene.units), realised = "eta_realised" + viscosity_key(scene.units);
  if (!scene.transport.eta_pairs)
    return "";
  auto const others = fmt::format("asked: {}{}, of the pairs: {}{}", number_text(scene.transport.eta, 4),
                                  unit, number_text(*scene.transport.eta_pairs, 4), unit);
  if (!summary.contains(realised))
    return others;
  cg::Estimate const found{summary[realised].get<double>(), summary[realised + "_se"].get<double>(), 1};
  return fmt::format("{}{} at {:g} spacings ({})", with_error_text(found), unit,
                     summary["viscosity_trials"]["wavelength_spacings"].get<double>(), others);
}

std::string plan_of_viscosity_trials(Scene const& scene) {
  auto const settings = settings_of_viscosity_trials(scene, 1);
  auto const lattice = settings.lattice;
  double const least = sdpd::least_viscosity_without_structure(settings);
  auto const unit = viscosity_unit(scene.units);
  auto text =
      fmt::format("eta_means = \"realised\": trials of {} particles find the friction of pairs with which "
                  "waves of {} mean "
                  "distances between particles have eta; motion and friction alone make {:.3g}{} at least",
                  settings.particle_count(), lattice[2], least, unit);
  if (scene.transport.eta < least)
    text += fmt::format(", more than the {:g}{} that are asked for: the run may refuse them",
                        scene.transport.eta, unit);
  return text;
}

} // namespace mesobridge::workflows
