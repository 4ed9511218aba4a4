#include "md/error.hpp"
#include "md/quasiharmonic_metal.hpp"
#include "md/units.hpp"
#include "workflows/command/options.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/lj/piston_balance.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/lj/sample_piston.hpp"
#include "workflows/metal/hugoniot_reference.hpp"
#include "workflows/ranks.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/shock.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/shock_study/shock_tables.hpp"
#include "workflows/summary.hpp"
#include <cmath>

namespace mesobridge::workflows {

namespace {

struct MdPistonShockOptions {
  std::string preset = "quick", metal, element, lattice, star;
  std::optional<double> rho0, T0, v_P; // SI, of stars in Lennard-Jones units
  std::optional<std::string> hugoniot;
  std::optional<int> cells_across, cells_along;
  std::optional<double> cutoff;
  std::optional<std::int64_t> steps;
  bool started_by_ourselves = false;
};

/// The fluid or crystal ahead, and its piston.
struct Ahead {
  double rho0, T0, v_P;
  double mass; ///< of an atom
  UnitSystem units = UnitSystem::SI;
};

/// A run that is planned, with what it starts from.
struct Plan {
  PistonJob job;
  Ahead ahead;
};

/// Until the front, of the velocity that Kolafa and Nezbeda's equation gives it, has come near the far end.
std::int64_t usual_steps(Ahead const& ahead, md::LjPistonSettings const& settings) {
  try {
    auto const shock = argon_shock("lj-kn", ahead.rho0, ahead.T0, ahead.v_P);
    return settings.steps(shock.v_S / argon_units.velocity());
  } catch (PhysicsError const& error) {
    throw InputError(fmt::format("--vp = {:g}: {}; give --steps", ahead.v_P, error.what()));
  }
}

/// What all kinds of runs may be told otherwise.
template <class Settings>
void take_sizes(Settings& settings, int& across, int& along, MdPistonShockOptions const& options,
                Context const& context) {
  across = options.cells_across.value_or(across), along = options.cells_along.value_or(along);
  settings.seed = context.options.seed.value_or(settings.seed);
  md::check(settings);
}

void refuse_words_of_metals(MdPistonShockOptions const& options) {
  for (auto const& [name, value] : {std::pair("--element", options.element), {"--lattice", options.lattice}})
    require(value.empty(), name, value, "needs --metal");
  require(!options.hugoniot, "--hugoniot", options.hugoniot.value_or(""), "needs --metal");
}

Plan argon_plan(MdPistonShockOptions const& options, Context const& context,
                std::filesystem::path const& log_file) {
  refuse_words_of_metals(options);
  Ahead const ahead{options.rho0.value_or(1150), options.T0.value_or(500), options.v_P.value_or(500),
                    argon_units.mass};
  auto settings = argon_piston(preset_of(options.preset), ahead.rho0, ahead.T0, ahead.v_P);
  settings.cutoff = options.cutoff.value_or(settings.cutoff);
  settings.log_file = log_file;
  take_sizes(settings, settings.cells_across, settings.cells_along, options, context);
  auto const steps = options.steps ? *options.steps : usual_steps(ahead, settings);
  return {{.settings = settings, .steps = steps, .directory = {}}, ahead};
}

Plan metal_plan(MdPistonShockOptions const& options, Context const& context,
                std::filesystem::path const& log_file) {
  require(!options.cutoff, "--cutoff", options.cutoff.value_or(0),
          "must not be given: the potential has its own");
  auto const potential = md::read_metal_potential(options.metal, options.element);
  auto const lattice = options.lattice.empty() ? potential.lattice : md::lattice_of(options.lattice);
  Ahead ahead{options.rho0.value_or(0), options.T0.value_or(300), options.v_P.value_or(1500), potential.mass};
  md::QuasiharmonicMetal metal(md::MpiWorld(),
                               {.potential = potential, .lattice = lattice, .log_file = log_file});
  if (!options.rho0)
    ahead.rho0 = metal.zero_pressure_density(ahead.T0);
  md::MetalState const state{ahead.rho0, ahead.T0};
  auto settings =
      md::metal_piston_settings(preset_of(options.preset), potential, lattice, state, ahead.v_P, log_file);
  take_sizes(settings, settings.cells_across, settings.cells_along, options, context);
  auto const usual = [&] {
    double const compression = metal.compression(state, ahead.v_P);
    return settings.steps(ahead.v_P * compression / (compression - 1));
  };
  auto const steps = options.steps ? *options.steps : usual();
  return {{.settings = settings, .steps = steps, .directory = {}}, ahead};
}

/// Until a front that is as fast as the piston and thermal beads together has come near the far end: slower
/// ones are seen before, and faster ones end the run.
Plan star_plan(MdPistonShockOptions const& options, Context const& context,
               std::filesystem::path const& log_file) {
  refuse_words_of_metals(options);
  require(options.metal.empty(), "--star", options.star, "must not be given beside --metal");
  require(!options.cutoff, "--cutoff", options.cutoff.value_or(0),
          "must not be given: the beads of stars repel each other up to 2^(1/6) sigma");
  auto settings = md::star_piston_settings(preset_of(options.preset));
  settings.star = md::star_of_name(options.star), settings.log_file = log_file;
  settings.rho = options.rho0.value_or(settings.rho), settings.T = options.T0.value_or(settings.T);
  settings.v_P = options.v_P.value_or(settings.v_P);
  take_sizes(settings, settings.across, settings.along, options, context);
  auto const steps = options.steps.value_or(settings.steps(settings.v_P + std::sqrt(settings.T)));
  return {{.settings = settings, .steps = steps, .directory = {}},
          {settings.rho, settings.T, settings.v_P, double(settings.star.atoms()), UnitSystem::lj}};
}

Plan plan_of(MdPistonShockOptions const& options, Context const& context) {
  auto const directory = context.output_directory("out/piston-shock");
  auto const log_file = directory / "lammps.log";
  auto const planned = !options.star.empty() ? star_plan : options.metal.empty() ? argon_plan : metal_plan;
  auto plan = planned(options, context, log_file);
  plan.job.directory = directory;
  auto const sample_every = std::visit([](auto const& of) { return of.sample_every; }, plan.job.settings);
  require(plan.job.steps >= sample_every, "--steps", plan.job.steps,
          fmt::format("must be at least {}: as many lie between two samples", sample_every));
  return plan;
}

/// The shock of argon by the equations of state that know the fluid there; none elsewhere, and for metals.
std::vector<NamedShock> equations(MdPistonShockOptions const& options, Ahead const& ahead) {
  if (!options.metal.empty() || !options.star.empty())
    return {};
  try {
    auto const cutoff = options.cutoff.value_or(md::LjPistonSettings().cutoff);
    return argon_shocks(ahead.rho0, ahead.T0, ahead.v_P, cutoff);
  } catch (PhysicsError const&) {
    return {};
  }
}

std::string text_of(PistonData const& data, std::optional<ShockOfRun> const& shock,
                    std::vector<NamedShock> const& exact) {
  auto text = data.description + "\n";
  if (!shock)
    return text + "no steady shock: the box is too short, or the run\n";
  auto const& m = shock->measured;
  if (data.units == UnitSystem::lj)
    return text + fmt::format("v_S       {}\nrho       {}\nP         {}\nT         {}\nT_centres {}\n",
                              with_error_text(m.v_S), with_error_text(m.rho), with_error_text(m.P),
                              with_error_text(m.T), with_error_text(shock->T_kin));
  text += fmt::format("v_S     {} m/s\nrho     {} kg/m^3\nP       {} GPa\nT       {} K\n",
                      with_error_text(m.v_S), with_error_text(m.rho),
                      with_error_text({m.P.mean * 1e-9, m.P.se * 1e-9, m.P.n_eff}), with_error_text(m.T));
  for (auto const& one : exact)
    text += fmt::format("Rankine-Hugoniot, {}: {:.1f} m/s, {:.1f} kg/m^3, {:.4f} GPa, {:.1f} K\n", one.name,
                        one.shock.v_S, one.shock.behind.rho, one.shock.behind.P * 1e-9, one.shock.behind.T);
  return text;
}

OutputUnits units_of(Ahead const& ahead) {
  return {{1, ahead.mass, ahead.rho0, ahead.T0, ahead.units == UnitSystem::SI ? k_B : 1}, ahead.units};
}

Report report_of(MdPistonShockOptions const& options, Ahead const& ahead, PistonData const& data,
                 std::optional<ShockOfRun> const& shock, std::vector<NamedShock> const& exact,
                 Provenance provenance) {
  bool const argon = options.metal.empty() && options.star.empty();
  std::string const what = argon                   ? "argon"
                           : !options.star.empty() ? "a melt of " + options.star + " stars"
                                                   : "a metal";
  Report report{.title = "A piston in " + what + " by molecular dynamics",
                .lead = data.description + ". Temperatures are those of the motion across, pressures P_zz" +
                        (argon ? " without a tail beyond the cut-off." : "."),
                .verdicts = {},
                .sections = {},
                .provenance = std::move(provenance),
                .sources = {"Thompson et al. 2022"}};
  if (argon)
    report.sources = {"Johnson et al. 1993", "Kolafa and Nezbeda 1994", "Thol et al. 2016",
                      "Thompson et al. 2022"};
  if (!shock) {
    report.warnings.push_back("There is no steady shock: the box is too short, or the run.");
    return report;
  }
  report.sections.push_back(shock_section(*shock, units_of(ahead)));
  if (exact.empty())
    return report;
  std::vector<ShownRow> rows;
  auto const row = md_row(data, *shock);
  rows.push_back({"MD", row, ""});
  report.sections.push_back(
      {"Equations of state",
       {shock_table(rows, exact, published("thesis-table-5.2.csv"),
                    "R.-H.: by the relations of Rankine and Hugoniot with equations of state of the "
                    "Lennard-Jones fluid.")}});
  report.sections.push_back(equations_section(&row, exact));
  return report;
}

Result piston_shock(MdPistonShockOptions const& options, Context const& context) {
  auto const [job, ahead] = plan_of(options, context); // before any rank starts: bad input is told once
  std::optional<HugoniotReference> reference;
  if (options.hugoniot)
    reference = read_hugoniot_reference(*options.hugoniot, {ahead.rho0, ahead.T0}, ahead.v_P);
  keep_earlier_results(context, options.started_by_ourselves, job.directory,
                       {job.file(), job.directory / "lammps.log", job.directory / "summary.json",
                        job.directory / "report.html"});
  if (!work_and_tell(context, options.started_by_ourselves, [&] { sample_piston(job, context); }))
    return told_elsewhere();
  auto const data = read_piston(job.file());
  auto const exact = equations(options, ahead);
  auto shock = shock_in(shock_data_of(data));
  if (shock && !exact.empty())
    shock->exact = exact.front().shock;
  auto const seed = std::visit([](auto const& of) { return of.seed; }, job.settings);
  Json summary{{"file", job.file().string()},
               {"settings", data.description},
               {"atoms", data.atoms},
               {"steps", job.steps},
               {"seed", seed}};
  auto const units = units_of(ahead);
  summary["rho0" + units.density_key] = ahead.rho0, summary["T0" + units.temperature_key] = ahead.T0,
                   summary["v_P" + units.velocity_key] = ahead.v_P;
  if (shock)
    put_shock(summary, *shock, units);
  if (!exact.empty()) {
    auto const row = shock ? std::optional(md_row(data, *shock)) : std::nullopt;
    summary["rankine_hugoniot_by_equation"] = equations_json(row ? &*row : nullptr, exact);
  }
  if (auto const balance = balance_of(data))
    summary["piston_pressure_by_energy"] = balance->by_energy,
    summary["piston_pressure_by_momentum"] = balance->by_momentum;
  auto report =
      report_of(options, ahead, data, shock, exact, {context.command_line(), seed, "", {job.file()}});
  auto text = text_of(data, shock, exact);
  if (reference && shock)
    text +=
        put_references(*reference, std::get<md::MetalPistonSettings>(job.settings), *shock, summary, report);
  auto result = with_report(job.directory, std::move(summary), report.html());
  result.text = text + result.text;
  return result;
}

void declare(CLI::App& app, MdPistonShockOptions& options) {
  add_preset(app, options.preset, "quick (minutes), standard (a quarter of an hour) or paper");
  app.add_option(
         "--metal", options.metal,
         "A metal in place of argon: its embedded-atom potential (.eam, .eam.alloy, .eam.fs), a file, "
         "or a name in lammps-data; the piston moves along <100>")
      ->type_name("FILE");
  app.add_option(
         "--star", options.star,
         "A melt of stars in place of argon, ARMS-BEADS; then --rho0 (default: 0.3 beads per sigma^3), "
         "--T0 (1) and --vp (0.5) are in Lennard-Jones units")
      ->type_name("N-N");
  app.add_option("--element", options.element, "Element of the potential (default: its only one)")
      ->type_name("NAME");
  app.add_option("--lattice", options.lattice, "fcc or bcc (default: the potential's)")->type_name("NAME");
  app.add_option(
         "--hugoniot", options.hugoniot,
         "hugoniot.csv of `md hugoniot` for the same metal from the same --rho0, --T0: compare with it")
      ->type_name("FILE");
  app.add_option("--rho0", options.rho0,
                 "Density at rest [kg/m^3] (default: 1150; of a metal about that of zero pressure)")
      ->type_name("REAL");
  app.add_option("--T0", options.T0, "Temperature at rest [K] (default: 500; of a metal 300)")
      ->type_name("REAL");
  app.add_option("--vp", options.v_P, "Velocity of the piston [m/s] (default: 500; in a metal 1500)")
      ->type_name("REAL");
  app.add_option("--cells-across", options.cells_across, "Cubic cells along x and y; of stars, molecules")
      ->type_name("INT");
  app.add_option("--cells-along", options.cells_along, "The same along z")->type_name("INT");
  app.add_option("--cutoff", options.cutoff, "Cut-off of the potential [sigma]")->type_name("REAL");
  app.add_option("--steps", options.steps,
                 "Steps while the piston moves; if not given, until the front is near the far end")
      ->type_name("INT");
  add_started_by_ourselves(app, options.started_by_ourselves);
}

} // namespace

extern Declaration const md_piston_shock_command = with_options<MdPistonShockOptions, declare, piston_shock>;

} // namespace mesobridge::workflows
