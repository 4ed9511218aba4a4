#include "workflows/sdpd/scene_findings.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

/// A finding as it lies in a folder; null if nothing is there, or nothing whole.
struct StoredFinding {
  Json found;
  std::string made_of;
};

StoredFinding read_finding(std::filesystem::path const& file) {
  StoredFinding stored;
  if (!std::filesystem::exists(file))
    return stored;
  try {
    stored.found = Json::parse(read_text_file(file));
    stored.made_of = stored.found.value("made_of", "");
    stored.found.erase("made_of");
    return stored;
  } catch (Json::exception const&) {
    return {}; // it is made again
  }
}

/// What the file has of the same fluid, or what `find` finds, which is then stored there.
template <class Find>
Json stored_or_found(std::filesystem::path const& file, std::string const& made_of, Find const& find) {
  if (auto stored = read_finding(file); stored.made_of == made_of)
    return std::move(stored.found);
  Json const found = find();
  auto kept = found;
  kept["made_of"] = made_of;
  write_summary(file, kept);
  return found;
}

/// How a value that the scene has was found; null if the file does not say it: damaged, or of another run.
Json past_finding(std::filesystem::path const& file, std::string const& key, std::optional<double> value) {
  auto stored = read_finding(file);
  bool const is_it = stored.found.is_object() && value && stored.found.value(key, 0.0) == *value;
  return is_it ? std::move(stored.found) : Json();
}

void find_densities(SceneFindings& all, RunFolder const& folder, RunOptions const& options) {
  auto& scene = all.scene;
  if (!wants_calibration(scene)) {
    if (options.past)
      all.densities = past_finding(folder.calibration(), "density_scale", scene.particles.density_scale);
    return;
  }
  all.densities = stored_or_found(folder.calibration(), calibration_identity(scene), [&] {
    auto const found = calibrate(scene, options.threads, [&] { return options.keep_going(0); });
    return calibration_json(found, OutputUnits(calibrated_settings(scene, 1).units(), scene.units));
  });
  scene.particles.density_scale = all.densities["density_scale"];
  scene.particles.density_self = all.densities["density_self"];
}

void find_viscosity(SceneFindings& all, RunFolder const& folder, RunOptions const& options) {
  auto& scene = all.scene;
  std::string const key = scene.units == UnitSystem::SI ? "eta_pairs_Pa_s" : "eta_pairs";
  if (!wants_trials_of_viscosity(scene)) {
    if (options.past)
      all.viscosity = past_finding(folder.viscosity_trials(), key, scene.transport.eta_pairs);
    return;
  }
  all.viscosity = stored_or_found(folder.viscosity_trials(), fluid_identity(scene), [&] {
    auto const found = find_viscosity_of_pairs(
        scene, options.threads, [&] { return options.keep_going(0); }, options.tell);
    return viscosity_trials_json(found, scene);
  });
  scene.transport.eta_pairs = all.viscosity[key];
}

} // namespace

SceneFindings with_findings_about_fluid(Scene scene, RunFolder const& folder, RunOptions const& options) {
  SceneFindings all{std::move(scene)};
  find_densities(all, folder, options);
  find_viscosity(all, folder, options);
  return all;
}

} // namespace mesobridge::workflows
