#include "fitting/particle_model_file.hpp"
#include "workflows/coarse/compared_shocks.hpp"
#include "workflows/coarse/star_to_dpde_report.hpp"
#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {
namespace {

struct WorkflowStarToDpdeOptions {
  std::string preset = "quick", star = "6-3";
  std::optional<double> rho, T, cutoff, run_time, v_P;
  std::optional<int> molecules, configurations, shock_across, shock_along;
  std::optional<std::int64_t> sampling_steps, sample_every, held_steps;
};

StarToDpdePlan plan_of(WorkflowStarToDpdeOptions const& options, std::uint64_t seed) {
  auto plan = star_to_dpde_plan(options.preset, seed);
  auto& melt = plan.melt;
  melt.star = md::star_of_name(options.star);
  melt.rho = options.rho.value_or(melt.rho);
  melt.T = options.T.value_or(melt.T);
  melt.molecules = options.molecules.value_or(melt.molecules);
  melt.sample_every = options.sample_every.value_or(melt.sample_every);
  melt.sampling_steps = options.sampling_steps.value_or(melt.sampling_steps);
  plan.configurations = options.configurations.value_or(plan.configurations);
  plan.held_steps = options.held_steps.value_or(plan.held_steps);
  plan.run_time = options.run_time.value_or(plan.run_time);
  plan.cutoff = options.cutoff;
  plan.v_P = options.v_P;
  for (auto const& [name, value] :
       {std::pair("--shock-across", options.shock_across), {"--shock-along", options.shock_along}})
    require(!value || options.v_P, name, value.value_or(0), "needs --shock");
  plan.shock_across = options.shock_across.value_or(plan.shock_across);
  plan.shock_along = options.shock_along.value_or(plan.shock_along);
  check(plan); // before anything is run
  return plan;
}

/// The temperature at which the model was found.
double temperature_of(std::filesystem::path const& model) {
  auto const state = fitting::parse_particle_model(read_text_file(model), model.string()).state;
  require(state.has_value(), "state of the model", model.string(), "must be there");
  return state->T;
}

/// Writes the scene of a stage, whose product from another scene does not count.
void write_scene(std::filesystem::path const& file, std::string const& text,
                 std::filesystem::path const& product) {
  if (std::filesystem::exists(file) && read_text_file(file) == text)
    return;
  std::filesystem::create_directories(file.parent_path());
  std::filesystem::remove(product);
  write_text_file(file, text);
}

/// Drives a piston into both fluids, after all else, and tells what comes of it.
void add_shocks(StarToDpdePlan const& plan, std::filesystem::path const& directory, double T,
                std::vector<Stage> stages, Context const& context, Json& summary, Report& report) {
  auto const more = shock_stages(plan, directory, T);
  write_scene(directory / "shock/scene.toml", shock_scene(plan, T, summary.at("P_dpde").get<double>()),
              more.back().product);
  stages.insert(stages.end(), more.begin(), more.end());
  make_stages(stages, directory / "stages.json", context);
  auto const shocks = read_shocks(plan, directory);
  summary["shock"] = shocks_json(shocks);
  report.sections.insert(report.sections.end() - 1, shocks_section(shocks, *plan.v_P, more));
}

Result star_to_dpde(WorkflowStarToDpdeOptions const& options, Context const& context) {
  std::uint64_t const seed = context.options.seed.value_or(1);
  auto const plan = plan_of(options, seed);
  auto const directory = context.output_directory("out/star-to-dpde");
  FolderLock const lock(directory, context.command_line());
  auto stages = model_stages(plan, directory);
  make_stages(stages, directory / "stages.json", context);
  double const T = temperature_of(stages.back().product);
  auto const scene = coarse_scene(plan, T);
  auto const later = run_stages(directory);
  write_scene(directory / "scene.toml", scene, later.front().product);
  stages.insert(stages.end(), later.begin(), later.end());
  make_stages(stages, directory / "stages.json", context);
  auto const kept = read_kept(plan, directory, context);
  auto report = star_to_dpde_report(plan, directory, kept);
  report.provenance = {context.command_line(), seed, scene, {}};
  auto summary = star_to_dpde_summary(plan, kept);
  summary["preset"] = options.preset;
  if (plan.v_P)
    add_shocks(plan, directory, T, stages, context, summary, report);
  return with_report(directory, std::move(summary), report.html());
}

void declare(CLI::App& app, WorkflowStarToDpdeOptions& options) {
  add_preset(app, options.preset, "quick (minutes), standard (an hour) or paper")->capture_default_str();
  app.add_option("--star", options.star, "ARMS-BEADS (default 6-3)")->type_name("N-N");
  app.add_option("--rho", options.rho, "Beads per sigma^3 (default 0.3)");
  app.add_option("--T", options.T, "Temperature of the thermostat (default 1)");
  app.add_option("--molecules", options.molecules, "Stars, and coarse particles; a cube such as 216");
  app.add_option("--sampling-steps", options.sampling_steps, "Steps of the melt at constant energy");
  app.add_option(
      "--sample-every", options.sample_every,
      "Steps between its frames, as long as a tenth of the decay of internal energies at most (default 25)");
  app.add_option("--configurations", options.configurations, "Of held centres");
  app.add_option("--held-steps", options.held_steps, "Steps that each of them is held");
  app.add_option("--run-time", options.run_time, "Of the coarse fluid (default 1000)");
  app.add_option(
         "--shock", options.v_P,
         "Velocity of a piston that drives a shock into the melt and into the particles, side by side")
      ->type_name("REAL");
  app.add_option("--shock-across", options.shock_across, "Molecules across the boxes of both")
      ->type_name("INT");
  app.add_option("--shock-along", options.shock_along, "Molecules along them")->type_name("INT");
  app.add_option("--cutoff", options.cutoff, "Of the potential (default: where g(r) is 1 within 0.02)");
}

} // namespace

Command::Action workflow_star_to_dpde_command(CLI::App& app) {
  return with_options<WorkflowStarToDpdeOptions>(app, declare, star_to_dpde);
}

} // namespace mesobridge::workflows
