#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/json_file.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/ranks.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/star/chapter.hpp"
#include "workflows/star/melt_summary.hpp"
#include "workflows/star/sample_melt.hpp"

namespace mesobridge::workflows {

namespace {

struct MdStarMeltOptions {
  std::string star = "6-3", preset;
  md::StarMeltSettings settings;
  bool resume = false;
  bool started_by_ourselves = false;
  CLI::App const* app = nullptr; ///< knows what the command line says
};

/// The preset's first melt, where the command line says nothing else.
void fill_in(MdStarMeltOptions& options) {
  if (options.preset.empty())
    return;
  auto const plan = chapter_plan(preset_of(options.preset), 1);
  auto const& [star, melts] = plan.molecules.front();
  auto const usual = melt_settings(plan, star, melts.front());
  auto const fill = [&](char const* option, auto& value, auto const& of_preset) {
    if (options.app->count(option) == 0)
      value = of_preset;
  };
  auto& s = options.settings;
  fill("--star", options.star, star.name());
  fill("--molecules", s.molecules, usual.molecules);
  fill("--rho", s.rho, usual.rho);
  fill("--dt", s.dt, usual.dt);
  fill("--equilibration-steps", s.equilibration_steps, usual.equilibration_steps);
  fill("--sampling-steps", s.sampling_steps, usual.sampling_steps);
  fill("--sample-every", s.sample_every, usual.sample_every);
}

Result star_melt(MdStarMeltOptions options, Context const& context) {
  fill_in(options);
  MeltJob job{.settings = options.settings, .resume = options.resume};
  job.settings.star = md::star_of_name(options.star);
  job.settings.seed = context.options.seed.value_or(job.settings.seed);
  md::check(job.settings); // before any rank starts: bad input is told once
  job.settings.directory = context.output_directory("out/star-melt");
  if (!options.resume)
    keep_earlier_results(context, options.started_by_ourselves, job.settings.directory,
                         {job.blobs(), job.summary(), job.settings.directory / "centres.h5",
                          job.settings.restart_file(), job.settings.log_file()});
  sample_melt_on_ranks(job, context);
  if (options.started_by_ourselves || !md::MpiWorld().is_root())
    return told_elsewhere();
  Result result;
  result.json = read_json(job.summary());
  result.text = melt_text(result.json);
  return result;
}

void declare(CLI::App& app, MdStarMeltOptions& options) {
  options.app = &app;
  auto& s = options.settings;
  add_preset(app, options.preset, "The 6-3 melt of chapter 3: quick (minutes), standard or paper");
  app.add_option("--star", options.star, "ARMS-BEADS, up to 12-24 (default 6-3)")->type_name("N-N");
  app.add_option("--molecules", s.molecules, "Number of stars (default 1000)");
  app.add_option("--rho", s.rho, "Beads per sigma^3 (default 0.3)");
  app.add_option("--T", s.T, "Temperature of the thermostat (default 1)");
  app.add_option("--friction", s.friction, "Friction of the thermostat (default 1)");
  app.add_option("--dt", s.dt, "Time step (default 0.001)");
  app.add_option("--squeeze-steps", s.squeeze_steps, "Steps of each growth of the density");
  app.add_option("--equilibration-steps", s.equilibration_steps, "Steps at the final density");
  app.add_option("--sampling-steps", s.sampling_steps, "Steps at constant energy");
  app.add_option("--sample-every", s.sample_every, "Steps between frames (default 100)");
  add_restarts(app, s.checkpoint_every, options.resume, options.started_by_ourselves);
}

} // namespace

Command::Action md_star_melt_command(CLI::App& app) {
  return with_options<MdStarMeltOptions>(app, declare, star_melt);
}

} // namespace mesobridge::workflows
