#include "fitting/particle_model_file.hpp"
#include "workflows/call_words.hpp"
#include "workflows/coarse/coarse_scenes.hpp"
#include "workflows/coarse/compared_shocks.hpp"
#include "workflows/coarse/melts_study.hpp"
#include "workflows/coarse/star_to_dpde_report.hpp"
#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>
#include <set>

namespace mesobridge::workflows {
namespace {

struct WorkflowStarToDpdeOptions {
  std::string preset = "quick";
  std::vector<std::string> stars;
  std::vector<double> densities;
  bool transfer = false;
  std::optional<double> T, cutoff, run_time, v_P;
  std::vector<double> run_dt;
  std::vector<std::string> other_models;
  std::optional<int> molecules, configurations, shock_across, shock_along;
  std::optional<std::int64_t> sampling_steps, sample_every, held_steps;
};

StarToDpdePlan plan_of(WorkflowStarToDpdeOptions const& options, std::uint64_t seed) {
  auto plan = star_to_dpde_plan(options.preset, seed);
  auto& melt = plan.melt;
  if (!options.stars.empty())
    melt.star = md::star_of_name(options.stars.front());
  if (!options.densities.empty())
    melt.rho = options.densities.front();
  melt.T = options.T.value_or(melt.T);
  melt.molecules = options.molecules.value_or(melt.molecules);
  melt.sample_every = options.sample_every.value_or(sample_every_at(melt.rho, melt.sample_every));
  melt.sampling_steps =
      options.sampling_steps.value_or(steps_at(melt.rho, melt.sampling_steps, melt.sample_every));
  md::check(melt);
  plan.configurations = options.configurations.value_or(plan.configurations);
  plan.held_steps =
      options.held_steps.value_or(steps_at(melt.rho, plan.held_steps, md::HeldBlobsSettings().sample_every));
  plan.run_time = options.run_time.value_or(plan.run_time);
  plan.cutoff = options.cutoff;
  if (!options.run_dt.empty() || !options.other_models.empty())
    plan.runs = coarse_runs(options.run_dt.empty() ? usual_time_steps() : options.run_dt,
                            {options.other_models.begin(), options.other_models.end()});
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

/// Leaves out the models of other melts whose pairs do not fit into the box.
void leave_out_wide_models(StarToDpdePlan& plan, Context const& context) {
  double const side = std::round(std::cbrt(double(plan.melt.molecules)));
  std::erase_if(plan.runs, [&](CoarseRun const& run) {
    int const least = run.model.empty() ? 0 : least_across(plan, run.range);
    bool const wide = least > side;
    if (wide)
      context.log->warn(
          "'{}' is left out: its pairs reach over {:.4g}, for which the box must be {} molecules wide; "
          "take more --molecules",
          run.model.string(), run.range, least);
    return wide;
  });
}

/// Writes the scene of a stage; what the stage has made of another scene does not count.
void write_scene_of(std::filesystem::path const& file, std::string const& text, Stage const& stage) {
  if (std::filesystem::exists(file) && read_text_file(file) == text)
    return;
  std::filesystem::create_directories(file.parent_path());
  std::filesystem::remove(stage.product), std::filesystem::remove(stage.begun);
  write_text_file(file, text);
}

/// Drives a piston into both fluids, after all else, and tells what comes of it.
void add_shocks(StarToDpdePlan plan, std::filesystem::path const& directory, double T,
                std::vector<Stage> stages, Context const& context, Json& summary, Report& report) {
  auto const model = directory / "model" / (plan.melt.star.name() + "-melt.toml");
  plan.shock_across = std::max(plan.shock_across, least_across(plan, range_of(model)));
  auto const more = shock_stages(plan, directory, T);
  write_scene_of(directory / "shock/scene.toml", shock_scene(plan, T, summary.at("P_dpde").get<double>()),
                 more.back());
  stages.insert(stages.end(), more.begin(), more.end());
  make_stages(stages, directory / "stages.json", context);
  auto const shocks = read_shocks(plan, directory);
  summary["shock"] = shocks_json(shocks);
  report.sections.insert(report.sections.end() - 1, shocks_section(shocks, *plan.v_P, more));
}

Result one_melt(WorkflowStarToDpdeOptions const& options, std::filesystem::path const& directory,
                Context const& context) {
  std::uint64_t const seed = context.options.seed.value_or(1);
  auto plan = plan_of(options, seed);
  leave_out_wide_models(plan, context);
  auto stages = model_stages(plan, directory);
  make_stages(stages, directory / "stages.json", context);
  double const T = temperature_of(stages.back().product);
  auto const later = run_stages(plan, directory);
  for (std::size_t k = 0; k < plan.runs.size(); ++k) // of two stages each
    write_scene_of(directory / plan.runs[k].scene(), coarse_scene(plan, plan.runs[k], T), later[2 * k]);
  stages.insert(stages.end(), later.begin(), later.end());
  make_stages(stages, directory / "stages.json", context);
  auto const kept = read_kept(plan, directory, context);
  auto report = star_to_dpde_report(plan, directory, kept);
  report.provenance = {context.command_line(), seed, coarse_scene(plan, plan.runs.front(), T), {}};
  auto summary = star_to_dpde_summary(plan, kept);
  summary["preset"] = options.preset;
  if (plan.v_P) {
    with_report(directory, summary, report.html()); // whatever comes of the shocks
    add_shocks(plan, directory, T, stages, context, summary, report);
  }
  return with_report(directory, std::move(summary), report.html());
}

/// What each chain of several is told besides its melt.
std::vector<std::string> further_words(WorkflowStarToDpdeOptions const& options, std::uint64_t seed) {
  CallWords call{{"--preset", options.preset, "--seed", std::to_string(seed)}};
  call.add("--T", options.T).add("--cutoff", options.cutoff).add("--run-time", options.run_time);
  call.add("--molecules", options.molecules).add("--configurations", options.configurations);
  call.add("--sampling-steps", options.sampling_steps).add("--sample-every", options.sample_every);
  call.add("--held-steps", options.held_steps).add("--shock", options.v_P);
  call.add("--shock-across", options.shock_across).add("--shock-along", options.shock_along);
  return call.add("--run-dt", options.run_dt).add("--other-model", options.other_models).words;
}

Result several_melts(WorkflowStarToDpdeOptions const& options, std::filesystem::path const& directory,
                     Context const& context) {
  std::uint64_t const seed = context.options.seed.value_or(1);
  MeltsStudy study{.stars = options.stars,
                   .densities = options.densities,
                   .words = further_words(options, seed),
                   .transfer = options.transfer};
  auto const usual = star_to_dpde_plan(options.preset, seed).melt;
  if (study.stars.empty())
    study.stars = {usual.star.name()};
  if (study.densities.empty())
    study.densities = {usual.rho};
  std::set<std::string> folders;
  for (auto const& star : study.stars)
    for (double const rho : study.densities) { // before anything is run
      require(folders.insert(melt_folder(star, rho)).second, "melt", melt_folder(star, rho),
              "must be named once");
      auto one = options;
      one.stars = {star}, one.densities = {rho};
      plan_of(one, seed);
    }
  make_stages(study_stages(study, directory), directory / "melts.json", context);
  auto summary = study_summary(study, directory);
  auto report = study_report(study, summary);
  report.provenance = {context.command_line(), seed, "", {}};
  summary["preset"] = options.preset;
  return with_report(directory, std::move(summary), report.html());
}

Result star_to_dpde(WorkflowStarToDpdeOptions const& options, Context const& context) {
  bool const several = options.stars.size() > 1 || options.densities.size() > 1;
  require(options.densities.size() > 1 || !options.transfer, "--transfer", "", "needs several --rho");
  auto const directory = context.output_directory("out/star-to-dpde");
  FolderLock const lock(directory, context.command_line());
  return several ? several_melts(options, directory, context) : one_melt(options, directory, context);
}

void declare(CLI::App& app, WorkflowStarToDpdeOptions& options) {
  add_preset(app, options.preset, "quick (minutes), standard (an hour) or paper")->capture_default_str();
  app.add_option("--star", options.stars,
                 "ARMS-BEADS; of several a chain each, and a report of all (default 6-3)")
      ->type_name("N-N");
  app.add_option("--rho", options.densities, "Beads per sigma^3, one or several (default 0.3)");
  app.add_flag("--transfer", options.transfer,
               "Run the model of the first of several densities at the others, too");
  app.add_option("--T", options.T, "Temperature of the thermostat (default 1)");
  app.add_option("--molecules", options.molecules, "Stars, and coarse particles; a cube such as 216");
  app.add_option("--sampling-steps", options.sampling_steps, "Steps of the melt at constant energy");
  app.add_option("--sample-every", options.sample_every,
                 "Steps between its frames, as long as a tenth of the decay of internal energies at most "
                 "(default 25, 10 above 0.4)");
  app.add_option("--configurations", options.configurations, "Of held centres");
  app.add_option("--held-steps", options.held_steps,
                 "Steps that each of them is held (default: 10000, more in melts below 0.3)");
  app.add_option("--run-time", options.run_time, "Of the coarse fluid (default 1000)");
  app.add_option("--run-dt", options.run_dt,
                 "Time steps of the coarse fluid, a run of each; what is kept is that of the first "
                 "(default 0.05 0.1 0.2)");
  app.add_option(
         "--other-model", options.other_models,
         "Models of other melts that are run beside the one found here: what a model is worth elsewhere")
      ->type_name("FILE");
  app.add_option(
         "--shock", options.v_P,
         "Velocity of a piston that drives a shock into the melt and into the particles, side by side")
      ->type_name("REAL");
  app.add_option("--shock-across", options.shock_across,
                 "Molecules across the boxes of both, or as many as the range of the potential needs")
      ->type_name("INT");
  app.add_option("--shock-along", options.shock_along, "Molecules along them")->type_name("INT");
  app.add_option("--cutoff", options.cutoff,
                 "Of the potential (default: 1.3 times where g(r) is 1 within 0.02)");
}

} // namespace

extern Declaration const workflow_star_to_dpde_command =
    with_options<WorkflowStarToDpdeOptions, declare, star_to_dpde>;

} // namespace mesobridge::workflows
