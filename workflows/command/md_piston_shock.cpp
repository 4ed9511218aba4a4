#include "md/error.hpp"
#include "md/units.hpp"
#include "workflows/command/options.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/lj/piston_file.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/lj/sample_piston.hpp"
#include "workflows/ranks.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/shock.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/shock_study/shock_tables.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {

namespace {

struct Options {
  std::string preset = "quick";
  double rho0 = 1150, T0 = 500, v_P = 500; // SI
  std::optional<int> cells_across, cells_along;
  std::optional<double> cutoff;
  std::optional<std::int64_t> steps;
  bool started_by_ourselves = false;
};

/// Until the front, of the velocity that Kolafa and Nezbeda's equation gives it, has come near the far end.
std::int64_t usual_steps(Options const& options, md::LjPistonSettings const& settings) {
  try {
    auto const shock = argon_shock("lj-kn", options.rho0, options.T0, options.v_P);
    return settings.steps(shock.v_S / argon_units.velocity());
  } catch (PhysicsError const& error) {
    throw InputError(fmt::format("--vp = {:g}: {}; give --steps", options.v_P, error.what()));
  }
}

LjPistonJob job_of(Options const& options, Context const& context) {
  LjPistonJob job{.settings = argon_piston(preset_of(options.preset), options.rho0, options.T0, options.v_P),
                  .directory = {}};
  auto& settings = job.settings;
  settings.cells_across = options.cells_across.value_or(settings.cells_across);
  settings.cells_along = options.cells_along.value_or(settings.cells_along);
  settings.cutoff = options.cutoff.value_or(settings.cutoff);
  settings.seed = context.options.seed.value_or(settings.seed);
  md::check(settings);
  job.steps = options.steps ? *options.steps : usual_steps(options, settings);
  require(job.steps >= settings.sample_every, "--steps", job.steps,
          fmt::format("must be at least {}: as many lie between two samples", settings.sample_every));
  job.directory = context.output_directory("out/piston-shock");
  settings.log_file = job.directory / "lammps.log";
  return job;
}

/// The shock by the equations of state that know the fluid there; none elsewhere.
std::vector<NamedShock> equations(Options const& options) {
  try {
    return argon_shocks(options.rho0, options.T0, options.v_P);
  } catch (PhysicsError const&) {
    return {};
  }
}

std::string text_of(LjPistonData const& data, std::optional<ShockOfRun> const& shock,
                    std::vector<NamedShock> const& exact) {
  auto text = data.description + "\n";
  if (!shock)
    return text + "no steady shock: the box is too short, or the run\n";
  auto const& m = shock->measured;
  text += fmt::format("v_S     {} m/s\nrho     {} kg/m^3\nP       {} GPa\nT       {} K\n",
                      with_error_text(m.v_S), with_error_text(m.rho),
                      with_error_text({m.P.mean * 1e-9, m.P.se * 1e-9, m.P.n_eff}), with_error_text(m.T));
  for (auto const& one : exact)
    text += fmt::format("Rankine-Hugoniot, {}: {:.1f} m/s, {:.1f} kg/m^3, {:.4f} GPa, {:.1f} K\n", one.name,
                        one.shock.v_S, one.shock.behind.rho, one.shock.behind.P * 1e-9, one.shock.behind.T);
  return text;
}

Report report_of(Options const& options, LjPistonData const& data, std::optional<ShockOfRun> const& shock,
                 std::vector<NamedShock> const& exact, Provenance provenance) {
  Report report{.title = "A piston in argon by molecular dynamics",
                .lead = data.description + ". Temperatures are those of the motion across, pressures P_zz "
                                           "without a tail beyond the cut-off.",
                .verdicts = {},
                .sections = {},
                .provenance = std::move(provenance),
                .sources = {"Johnson et al. 1993", "Kolafa and Nezbeda 1994", "Thol et al. 2016",
                            "Thompson et al. 2022"}};
  if (!shock) {
    report.warnings.push_back("There is no steady shock: the box is too short, or the run.");
    return report;
  }
  OutputUnits const units({1, argon_units.mass, options.rho0, options.T0, k_B}, UnitSystem::SI);
  report.sections.push_back(shock_section(*shock, units));
  std::vector<ShownRow> rows;
  auto const row = md_row(data, *shock);
  rows.push_back({"MD", row, ""});
  report.sections.push_back(
      {"Equations of state",
       {shock_table(rows, exact, published("thesis-table-5.2.csv"),
                    "R.-H.: by the relations of Rankine and Hugoniot with equations of state of the "
                    "Lennard-Jones fluid.")}});
  return report;
}

Result piston_shock(Options const& options, Context const& context) {
  auto const job = job_of(options, context); // before any rank starts: bad input is told once
  keep_earlier_results(
      context, options.started_by_ourselves, job.directory,
      {job.file(), job.settings.log_file, job.directory / "summary.json", job.directory / "report.html"});
  if (!work_and_tell(context, options.started_by_ourselves, [&] { sample_piston(job, context); }))
    return told_elsewhere();
  auto const data = read_lj_piston(job.file());
  auto const exact = equations(options);
  auto shock = shock_in(data.frames, data.scale);
  if (shock && !exact.empty())
    shock->exact = exact.front().shock;
  Json summary{{"file", job.file().string()},
               {"settings", data.description},
               {"atoms", data.atoms},
               {"steps", job.steps},
               {"seed", job.settings.seed}};
  if (shock)
    put_shock(summary, *shock, {{1, argon_units.mass, options.rho0, options.T0, k_B}, UnitSystem::SI});
  for (auto const& one : exact)
    summary["equations_of_state"].push_back(
        {{"model", one.key}, {"rankine_hugoniot", shock_json(one.shock)}});
  auto const report =
      report_of(options, data, shock, exact, {context.command_line(), job.settings.seed, "", {job.file()}});
  auto result = with_report(job.directory, std::move(summary), report.html());
  result.text = text_of(data, shock, exact) + result.text;
  return result;
}

void declare(CLI::App& app, Options& options) {
  add_preset(app, options.preset, "quick (minutes), standard (a quarter of an hour) or paper");
  app.add_option("--rho0", options.rho0, "Density at rest [kg/m^3]");
  app.add_option("--T0", options.T0, "Temperature at rest [K]");
  app.add_option("--vp", options.v_P, "Velocity of the piston [m/s]");
  app.add_option("--cells-across", options.cells_across, "Cells of 4 atoms along x and y")->type_name("INT");
  app.add_option("--cells-along", options.cells_along, "Cells of 4 atoms along z")->type_name("INT");
  app.add_option("--cutoff", options.cutoff, "Cut-off of the potential [sigma]")->type_name("REAL");
  app.add_option("--steps", options.steps,
                 "Steps while the piston moves; if not given, until the front is near the far end")
      ->type_name("INT");
  add_started_by_ourselves(app, options.started_by_ourselves);
}

} // namespace

Command::Action md_piston_shock_command(CLI::App& app) {
  return with_options(app, declare, piston_shock);
}

} // namespace mesobridge::workflows
