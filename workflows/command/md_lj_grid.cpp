#include "md/error.hpp"
#include "md/mpi_world.hpp"
#include "workflows/command/options.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/lj/sample_grid.hpp"
#include "workflows/ranks.hpp"
#include "workflows/shared_options.hpp"

namespace mesobridge::workflows {

namespace {

struct MdLjGridOptions {
  std::string preset = "quick";
  std::optional<int> atoms, densities, temperatures;
  std::optional<std::int64_t> sampling_steps;
  std::optional<double> cutoff;
  md::LjRegion region = md::default_lj_region;
  bool started_by_ourselves = false;
};

LjGridJob job_of(MdLjGridOptions const& options, Context const& context) {
  auto const preset = preset_of(options.preset);
  int const edge = static_cast<int>(std::lround(std::sqrt(md::default_lj_grid(preset).size())));
  LjGridJob job{.states = md::lj_grid(options.region, options.densities.value_or(edge),
                                      options.temperatures.value_or(edge)),
                .settings = md::lj_fluid_settings(preset),
                .directory = {}};
  auto& settings = job.settings;
  settings.atoms = options.atoms.value_or(settings.atoms);
  settings.cutoff = options.cutoff.value_or(settings.cutoff);
  settings.sampling_steps = options.sampling_steps.value_or(settings.sampling_steps);
  settings.seed = context.options.seed.value_or(settings.seed);
  for (auto const state : job.states)
    md::check(state, settings);
  job.directory = context.output_directory("out/lj-grid");
  settings.log_file = job.directory / "lammps.log";
  return job;
}

Result lj_grid(MdLjGridOptions const& options, Context const& context) {
  auto const job = job_of(options, context); // before any rank starts: bad input is told once
  keep_earlier_results(context, options.started_by_ourselves, job.directory,
                       {job.directory / "lj-grid.h5", job.settings.log_file});
  if (!work_and_tell(context, options.started_by_ourselves, [&] { sample_grid(job, context); }))
    return told_elsewhere();
  auto const file = (job.directory / "lj-grid.h5").string();
  Result result;
  result.json = {{"file", file},
                 {"states", job.states.size()},
                 {"atoms", job.settings.atoms},
                 {"cutoff", job.settings.cutoff},
                 {"sampling_steps", job.settings.sampling_steps},
                 {"seed", job.settings.seed},
                 {"settings", job.settings.description()}};
  result.text = fmt::format("{} states ({}) in {}", job.states.size(), job.settings.description(), file);
  return result;
}

void declare(CLI::App& app, MdLjGridOptions& options) {
  add_preset(app, options.preset, "quick (minutes), standard (an hour) or paper");
  app.add_option("--atoms", options.atoms, "Atoms of one state, 4 n^3")->type_name("INT");
  app.add_option("--cutoff", options.cutoff, "Cut-off of the potential [sigma]")->type_name("REAL");
  app.add_option("--sampling-steps", options.sampling_steps, "Sampled steps of one state")->type_name("INT");
  app.add_option("--rho-min", options.region.rho_min, "Region: lowest density [sigma^-3]");
  app.add_option("--rho-max", options.region.rho_max, "Region: highest density [sigma^-3]");
  app.add_option("--T-min", options.region.T_min, "Region: lowest temperature [epsilon/k_B]");
  app.add_option("--T-max", options.region.T_max, "Region: highest temperature [epsilon/k_B]");
  app.add_option("--densities", options.densities, "Densities of the grid")->type_name("INT");
  app.add_option("--temperatures", options.temperatures, "Temperatures of the grid")->type_name("INT");
  add_started_by_ourselves(app, options.started_by_ourselves);
}

} // namespace

extern Declaration const md_lj_grid_command = with_options<MdLjGridOptions, declare, lj_grid>;

} // namespace mesobridge::workflows
