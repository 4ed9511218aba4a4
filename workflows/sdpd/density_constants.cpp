#include "workflows/sdpd/density_constants.hpp"
#include "md/error.hpp"
#include "sdpd/scheme/list.hpp"
#include "workflows/sdpd/layout_of.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/scene_inputs.hpp"
#include "workflows/summary.hpp"
#include "workflows/version.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

/// Of which a calibration runs a part.
constexpr std::array<std::uint32_t, 3> roomy_lattice{32, 32, 32};

/// Density and temperature.
struct CalibratedState {
  double rho, T;
};

/// Where the constants are to hold.
CalibratedState state_of(Scene const& scene) {
  auto const& particles = scene.particles;
  if (particles.density != "calibrated-shocked")
    return {scene.fluid.rho, scene.fluid.T};
  try {
    auto const shock = piston_shock(settings_of(fluid_alone(scene), 1), scene.box.piston.value());
    return {shock->behind.rho, shock->behind.T};
  } catch (PhysicsError const& error) {
    throw InputError(fmt::format("particles.density = \"{}\": {}", particles.density, error.what()));
  }
}

/// The same particles with the same kernels and time step, in units of that state and in a box of their own.
sdpd::SimulationSettings at(CalibratedState const& state, sdpd::SimulationSettings settings) {
  if (state.rho == settings.rho && state.T == settings.T)
    return settings;
  auto const before = settings.units();
  settings.lattice = roomy_lattice, settings.faces = {};
  settings.as<sdpd::Sdpd>().h_factor *= std::cbrt(state.rho / settings.rho);
  settings.rho = state.rho, settings.T = state.T;
  double const time = before.time() / settings.units().time();
  settings.dt *= time, settings.bath_rate /= time;
  return settings;
}

/// What the scene says or, if it leaves that open, what suits its fluid; none where there is nothing to
/// calibrate: without noise particles come to rest somewhere, and those that do not move have no equilibrium,
/// whose mean density and pressure could be set right.
std::optional<sdpd::ScaleCondition> condition_of(Scene const& scene) {
  auto const& density = scene.particles.density;
  if (density.starts_with("calibrated"))
    return density == "calibrated-response" ? sdpd::ScaleCondition::response : sdpd::ScaleCondition::pressure;
  if (density != "auto" || !scene.noise() ||
      !sdpd::conservative_integrator(scene.scheme.conservative).moves())
    return std::nullopt;
  return sdpd::suitable_condition(calibrated_settings(scene, 1));
}

} // namespace

Scene fluid_alone(Scene scene) {
  scene.reaction = {};
  if (has_layout(scene))
    scene.regions.clear(), scene.box = {}, scene.particles.N = 32 * 32 * 32;
  return scene;
}

bool wants_calibration(Scene const& scene) {
  return scene.features().densities && !scene.particles.density_scale && condition_of(scene);
}

std::int64_t calibration_steps(Scene const& scene) {
  if (scene.particles.calibration_steps > 0)
    return scene.particles.calibration_steps;
  return std::clamp<std::int64_t>((scene.run.equilibrate + scene.run.steps) / 4, 200, 6000);
}

sdpd::ScaleCondition scale_condition_of(Scene const& scene) {
  return condition_of(scene).value();
}

sdpd::SimulationSettings calibrated_settings(Scene const& scene, int threads) {
  auto const settings = settings_of(fluid_alone(scene), threads);
  return scene.features().densities ? at(state_of(scene), settings) : settings;
}

sdpd::DensityCalibration calibrate(Scene const& scene, int threads, std::function<bool()> const& keep_going) {
  auto const settings = calibrated_settings(scene, threads);
  try {
    return sdpd::calibrate_density(settings, scale_condition_of(scene),
                                   static_cast<std::uint64_t>(calibration_steps(scene)), keep_going);
  } catch (PhysicsError const& error) {
    throw PhysicsError(
        fmt::format("while the densities were calibrated (particles.density = \"{}\"; \"plain\" "
                    "leaves them as they are): {}",
                    scene.particles.density, error.what()));
  }
}

std::string calibration_identity(Scene const& scene) {
  return sha256(fmt::format("{}\n{}", fluid_identity(scene), calibration_steps(scene)));
}

Json calibration_json(sdpd::DensityCalibration const& c, OutputUnits const& units) {
  Json json;
  json["density_scale"] = c.constants.scale;
  json["density_scale_se"] = c.scale_se;
  json["density_self"] = c.constants.self;
  json["density_self_se"] = c.self_se;
  put(json, "last_stage_rho" + units.density_key,
      {c.rho.mean * units.density, c.rho.se * units.density, c.rho.n_eff});
  put(json, "last_stage_P" + units.pressure_key,
      {c.P.mean * units.pressure, c.P.se * units.pressure, c.P.n_eff});
  json["P_eos" + units.pressure_key] = c.P_eos * units.pressure;
  json["particles"] = c.particles;
  json["steps"] = c.steps;
  return json;
}

} // namespace mesobridge::workflows
