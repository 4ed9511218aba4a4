#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/ranks.hpp"
#include "workflows/scene/tolerance.hpp"
#include "workflows/sdpd/lammps_run.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/shortage.hpp"
#include "workflows/sdpd/start_picture.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "workflows/study/dynamics.hpp"
#include "workflows/study/rounded_dt.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>
#include <fmt/ranges.h>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

struct CheckOptions {
  std::string scene, engine = "built-in";
  std::vector<std::string> overrides;
  std::optional<std::string> drawing;
  bool keys = false;
};

std::string cost_text(CostEstimate const& cost, DiskEstimate const& disk, std::string const& on) {
  auto text = fmt::format("\n# about {} on {}, {} of memory, {} on the disk; {:.0f} neighbours a particle",
                          duration_text(cost.seconds), on, bytes_text(cost.bytes), bytes_text(disk.total()),
                          cost.neighbours);
  if (cost.study_seconds > 0)
    text += fmt::format("\n# of that time {} to find the time step", duration_text(cost.study_seconds));
  if (cost.calibration_seconds > 0)
    text += fmt::format("\n# of that time {} to calibrate the densities",
                        duration_text(cost.calibration_seconds));
  if (cost.viscosity_seconds > 0)
    text +=
        fmt::format("\n# of that time {} for trials of the viscosity", duration_text(cost.viscosity_seconds));
  return text;
}

/// The time step in the engine's unit and in the scene's.
void put_time_step(Result& result, sdpd::SimulationSettings const& settings, UnitSystem system) {
  OutputUnits const units(settings.units(), system);
  result.json["dt_reduced"] = settings.dt;
  result.json["dt" + units.time_key] = settings.dt * units.time;
  result.text += fmt::format("\n# dt = {:.6g} reduced (a plain number in the scene) = \"{:.6g} {}\"",
                             settings.dt, settings.dt * units.time, system == UnitSystem::lj ? "tau" : "s");
}

/// The time step that surely keeps the wanted dynamics: trials may find that a longer one does.
void put_dynamic_step(Result& result, Scene const& scene) {
  double const bound = dt_by_bound(scene, parse_share(*scene.scheme.dynamics));
  if (!std::isfinite(bound)) // without friction no step of it can be too long
    return;
  double const dt = rounded_down(bound);
  result.json["dynamics_dt_reduced_at_least"] = dt;
  result.text += fmt::format("\n# dynamics {}: dt = {:g} reduced keeps it for a particle alone; trials find "
                             "how much longer it may be",
                             *scene.scheme.dynamics, dt);
}

Result check(CheckOptions const& options, Context const& context) {
  if (options.keys)
    return {.json = {{"keys", scene_keys_text()}}, .text = scene_keys_text(), .complaint = ""};
  require(!options.scene.empty(), "SCENE", "''", "a scene file is needed (or --keys)");
  int const threads = context.options.threads.value_or(available_threads());
  Scene const scene = load_run(options.scene, options.overrides, threads, engine_named(options.engine));
  int const ranks = ranks_of(context);
  auto const engine = engine_named(options.engine);
  auto const cost = estimate_cost(scene, threads, engine, ranks);
  auto const on =
      engine == Engine::lammps ? fmt::format("{} rank(s)", ranks) : fmt::format("{} thread(s)", threads);
  auto const disk = estimate_disk(scene);
  auto const settings = settings_for_check(scene, threads);
  auto warnings = shortages(cost, disk, results_folder(context.options.output, scene, options.scene));
  for (auto const& doubt : doubts_about(scene, settings))
    warnings.push_back(doubt.text);
  for (auto const& what : warnings)
    context.log->warn("warning: {}", what);
  auto const resolved = resolved_toml(scene);
  auto const regions = region_lines(scene, settings);
  Result result{.json = {{"scene", options.scene},
                         {"valid", true},
                         {"warnings", warnings},
                         {"resolved", resolved},
                         {"estimated_neighbours", cost.neighbours},
                         {"estimated_time_s", cost.seconds},
                         {"estimated_time_step_study_s", cost.study_seconds},
                         {"estimated_calibration_s", cost.calibration_seconds},
                         {"estimated_viscosity_trials_s", cost.viscosity_seconds},
                         {"estimated_memory_bytes", cost.bytes},
                         {"estimated_disk_bytes", disk.total()},
                         {"estimated_disk_results_bytes", disk.results},
                         {"estimated_disk_trajectories_bytes", disk.trajectories},
                         {"estimated_disk_checkpoint_bytes", disk.checkpoint}},
                .text = resolved +
                        (regions.empty() ? "" : fmt::format("\n# {}", fmt::join(regions, "\n# "))) +
                        cost_text(cost, disk, on),
                .complaint = ""};
  if (wants_trials_of_viscosity(scene)) {
    result.json["eta_plan"] = plan_of_viscosity_trials(scene);
    result.text += "\n# " + plan_of_viscosity_trials(scene);
  }
  if (!scene.scheme.dt.automatic)
    put_time_step(result, settings, scene.units);
  else if (scene.scheme.dynamics)
    put_dynamic_step(result, scene);
  if (!regions.empty())
    result.json["regions"] = regions;
  if (options.drawing) {
    write_text_file(*options.drawing, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
                                          draw_svg(start_picture(scene, settings)));
    result.json["drawing"] = *options.drawing;
    result.text += "\n# the start is drawn in " + *options.drawing;
  }
  return result;
}

void declare(CLI::App& app, CheckOptions& options) {
  app.add_option("scene", options.scene, "The scene file")->type_name("SCENE.toml");
  app.add_option("--set", options.overrides, "Replace a value: section.key=value")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  add_engine(app, options.engine);
  app.add_option("--draw", options.drawing, "Draw where the particles begin")->type_name("FILE.svg");
  app.add_flag("--keys", options.keys, "Explain all keys of a scene");
}

} // namespace

extern Declaration const check_command = with_options<CheckOptions, declare, check>;

} // namespace mesobridge::workflows
