#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/json_file.hpp"
#include "workflows/ranks.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/star/sample_vacuum.hpp"

namespace mesobridge::workflows {

namespace {

struct MdStarVacuumOptions {
  std::string star = "6-3";
  md::StarVacuumSettings settings;
  std::vector<double> temperatures, energies;
  bool resume = false;
  bool started_by_ourselves = false;
};

std::string text_of(Json const& summary) {
  std::string text = fmt::format("{} isolated {} stars, {}: {} frames\n", summary["molecules"].get<int>(),
                                 summary["star"].get<std::string>(), summary["ensemble"].get<std::string>(),
                                 summary["frames"].get<int>());
  for (auto const& level : summary["levels"])
    if (level.contains("U_mean"))
      text += fmt::format("set {:<8.5g} <U> = {:.6g} +- {:.2g}   <E_kin> = {:.6g} +- {:.2g}\n",
                          level["set"].get<double>(), level["U_mean"].get<double>(),
                          level["U_mean_se"].get<double>(), level["U_kin_mean"].get<double>(),
                          level["U_kin_mean_se"].get<double>());
  return text + summary["file"].get<std::string>();
}

Result star_vacuum(MdStarVacuumOptions const& options, Context const& context) {
  VacuumJob job{.settings = options.settings, .resume = options.resume};
  auto& s = job.settings;
  s.star = md::star_of_name(options.star);
  s.seed = context.options.seed.value_or(s.seed);
  if (!options.temperatures.empty())
    s.levels = options.temperatures;
  if (!options.energies.empty()) {
    s.ensemble = md::VacuumEnsemble::microcanonical;
    s.levels = options.energies;
  }
  md::check(s); // before any rank starts: bad input is told once
  s.directory = context.output_directory("out/star-vacuum");
  if (!options.resume)
    keep_earlier_results(context, options.started_by_ourselves, s.directory,
                         {job.blobs(), job.summary(), s.restart_file(), s.log_file()});
  sample_vacuum_on_ranks(job, context);
  if (options.started_by_ourselves || !md::MpiWorld().is_root())
    return told_elsewhere();
  Result result;
  result.json = read_json(job.summary());
  result.text = text_of(result.json);
  return result;
}

void declare(CLI::App& app, MdStarVacuumOptions& options) {
  auto& s = options.settings;
  app.add_option("--star", options.star, "ARMS-BEADS, up to 12-24 (default 6-3)")->type_name("N-N");
  auto* const T = app.add_option("--T", options.temperatures,
                                 "Temperatures, shared by the molecules in turn (0.85 1 1.18)");
  app.add_option("--U", options.energies, "Instead: energies, kept without a thermostat")->excludes(T);
  app.add_option("--molecules", s.molecules, "Number of stars (default 600)");
  app.add_option("--dt", s.dt, "Time step (default 0.001)");
  app.add_option("--redraw-every", s.redraw_every, "Steps between draws of the velocities");
  app.add_option("--equilibration-steps", s.equilibration_steps, "Steps before sampling");
  app.add_option("--sampling-steps", s.sampling_steps, "Sampled steps");
  app.add_option("--sample-every", s.sample_every, "Steps between frames (default 250)");
  add_restarts(app, s.checkpoint_every, options.resume, options.started_by_ourselves);
}

} // namespace

Command::Action md_star_vacuum_command(CLI::App& app) {
  return with_options<MdStarVacuumOptions>(app, declare, star_vacuum);
}

} // namespace mesobridge::workflows
