#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/star/chapter.hpp"
#include "workflows/summary.hpp"
#include <optional>

namespace mesobridge::workflows {

namespace {

struct WorkflowStarPolymersOptions {
  std::string preset = "quick";
  std::vector<std::string> stars;
  std::vector<double> densities;
  std::optional<int> molecules, vacuum_molecules;
  std::optional<std::int64_t> sampling_steps, vacuum_sampling_steps;
};

/// The preset's plan with what the user wants otherwise.
ChapterPlan plan_of(WorkflowStarPolymersOptions const& options, std::uint64_t seed) {
  auto plan = chapter_plan(preset_of(options.preset), seed);
  plan.vacuum.molecules = options.vacuum_molecules.value_or(plan.vacuum.molecules);
  plan.vacuum.sampling_steps = options.vacuum_sampling_steps.value_or(plan.vacuum.sampling_steps);
  auto const usual = plan.molecules.front().melts.front();
  if (!options.stars.empty()) {
    plan.molecules.clear();
    for (auto const& name : options.stars)
      plan.molecules.push_back({md::star_of_name(name), {usual}});
  }
  for (auto& [star, melts] : plan.molecules) {
    if (!options.densities.empty()) {
      melts.clear();
      for (double const rho : options.densities)
        melts.push_back({rho, usual.molecules, usual.sampling_steps});
    }
    for (auto& melt : melts) {
      melt.molecules = options.molecules.value_or(melt.molecules);
      melt.sampling_steps = options.sampling_steps.value_or(melt.sampling_steps);
    }
  }
  check(plan); // before anything is run
  return plan;
}

Result star_polymers(WorkflowStarPolymersOptions const& options, Context const& context) {
  std::uint64_t const seed = context.options.seed.value_or(1);
  auto const plan = plan_of(options, seed);
  auto const directory = context.output_directory("out/star-polymers");
  FolderLock const lock(directory, context.command_line());
  auto const chapter = run_chapter(plan, directory, context);
  auto report = chapter_report(chapter);
  report.provenance = {context.command_line(), seed, "", {}};
  auto summary = chapter_summary(chapter);
  summary["preset"] = options.preset;
  return with_report(directory, std::move(summary), report.html());
}

void declare(CLI::App& app, WorkflowStarPolymersOptions& options) {
  add_preset(app, options.preset, "quick (minutes), standard (hours; goes on when run again) or paper")
      ->capture_default_str();
  app.add_option("--star", options.stars, "ARMS-BEADS of other molecules than the preset's")
      ->type_name("N-N");
  app.add_option("--rho", options.densities, "Beads per sigma^3 of other melts than the preset's");
  app.add_option("--molecules", options.molecules, "Stars in each melt");
  app.add_option("--sampling-steps", options.sampling_steps, "Steps of each melt at constant energy");
  app.add_option("--vacuum-molecules", options.vacuum_molecules, "Isolated stars");
  app.add_option("--vacuum-sampling-steps", options.vacuum_sampling_steps,
                 "Steps of the isolated stars at set temperatures");
}

} // namespace

extern Declaration const workflow_star_polymers_command =
    with_options<WorkflowStarPolymersOptions, declare, star_polymers>;

} // namespace mesobridge::workflows
