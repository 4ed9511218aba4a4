#include "workflows/sdpd/density_constants.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {

bool wants_calibration(Scene const& scene) {
  return scene.particles.density.starts_with("calibrated") && !scene.particles.density_scale;
}

sdpd::ScaleCondition scale_condition_of(Scene const& scene) {
  return scene.particles.density == "calibrated" ? sdpd::ScaleCondition::pressure
                                                 : sdpd::ScaleCondition::response;
}

sdpd::DensityCalibration calibrate(Scene const& scene, int threads, std::function<bool()> const& keep_going) {
  return sdpd::calibrate_density(settings_of(scene, threads), scale_condition_of(scene),
                                 static_cast<std::uint64_t>(scene.particles.calibration_steps), keep_going);
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
