#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/star/sample_vacuum.hpp"
#include "workflows/star/star_options.hpp"

namespace mesobridge::workflows {

namespace {

struct MdStarVacuumOptions {
  StarOptions stars;
  md::StarVacuumSettings settings;
  std::vector<double> temperatures, energies;
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
  VacuumJob job{.settings = options.settings};
  if (!options.temperatures.empty())
    job.settings.levels = options.temperatures;
  if (!options.energies.empty()) {
    job.settings.ensemble = md::VacuumEnsemble::microcanonical;
    job.settings.levels = options.energies;
  }
  return sampled(job, options.stars, "out/star-vacuum", {}, sample_vacuum_on_ranks, text_of, context);
}

void declare(CLI::App& app, MdStarVacuumOptions& options) {
  add_options(app, options.stars, options.settings, "Steps before sampling", "Sampled steps");
  auto* const T = app.add_option("--T", options.temperatures,
                                 "Temperatures, shared by the molecules in turn (0.85 1 1.18)");
  app.add_option("--U", options.energies, "Instead: energies, kept without a thermostat")->excludes(T);
  app.add_option("--redraw-every", options.settings.redraw_every, "Steps between draws of the velocities");
}

} // namespace

extern Declaration const md_star_vacuum_command = with_options<MdStarVacuumOptions, declare, star_vacuum>;

} // namespace mesobridge::workflows
