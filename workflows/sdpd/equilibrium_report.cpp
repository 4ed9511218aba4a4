#include "workflows/sdpd/equilibrium_report.hpp"
#include "fitting/eos/evaluate.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/detonation.hpp"
#include "workflows/sdpd/equilibrium_plots.hpp"
#include "workflows/sdpd/film.hpp"
#include "workflows/sdpd/flow.hpp"
#include "workflows/sdpd/measured_report.hpp"
#include "workflows/sdpd/riemann_problem.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include "workflows/sdpd/shock.hpp"
#include "workflows/sdpd/space_time.hpp"
#include "workflows/sdpd/start_picture.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

std::string with_unit(std::string const& quantity, std::string const& unit) {
  return unit.empty() ? quantity : quantity + " [" + unit + "]";
}

/// Energy per mass and its drift, for which there is nothing to compare with.
void add_energies(Table& table, RunResult const& run, OutputUnits const& units) {
  auto const& e = run.equilibrium;
  bool const si = run.scene.units == UnitSystem::SI;
  table.rows.push_back({with_unit("internal energy per mass", si ? "J/kg" : ""),
                        with_error_text(scaled(e.eps.mean, units.specific_energy)), "", "", ""});
  table.rows.push_back(
      {with_unit("drift of the energy, relative", si ? "1/ps" : "1/time"),
       with_error_text(scaled(cg::Estimate{e.drift.rate, e.drift.se, 8}, 1 / (units.time * (si ? 1e12 : 1)))),
       "0", "", ""});
  if (run.summary.contains("energy_balance_error"))
    table.rows.push_back({"energy that is missing, of what was turned over [%]",
                          number_text(100 * run.summary["energy_balance_error"].get<double>(), 2), "0", "",
                          ""});
}

/// Means over the run beside what the settings say of them; what has no such value stands alone.
Table numbers(RunResult const& run, OutputUnits const& units) {
  auto const& e = run.equilibrium;
  auto const& settings = run.settings;
  auto const features = settings.features();
  bool const energies = features.energies, densities = features.densities;
  bool const si = run.scene.units == UnitSystem::SI;
  Table table{.header = comparison_header(),
              .caption = densities ? "Means over the run beside the equation of state at the set density and "
                                     "temperature."
                                   : "Means over the run beside the set temperature."};
  table.rows.push_back(comparison_row(with_unit("kinetic temperature", si ? "K" : ""),
                                      scaled(e.T_kin, units.temperature), settings.T));
  if (energies)
    table.rows.push_back(comparison_row(
        with_unit(densities ? "internal temperature" : "internal temperature (harmonic mean)", si ? "K" : ""),
        scaled(e.T_int, units.temperature), settings.T));
  auto const pressure = with_unit("pressure", si ? "Pa" : "");
  auto const P = scaled(e.P, units.pressure);
  if (densities) {
    auto const state = std::visit(
        [&](auto const& eos) { return fitting::state_from_temperature(eos, settings.rho, settings.T); },
        settings.as<sdpd::Sdpd>().eos);
    table.rows.push_back(comparison_row(pressure, P, state.P));
    table.rows.push_back(comparison_row(with_unit("mean density", si ? "kg/m^3" : ""),
                                        scaled(e.rho.mean, units.density), state.rho));
  } else
    table.rows.push_back({pressure, with_error_text(P), "", "", ""});
  if (energies)
    add_energies(table, run, units);
  if (auto const viscosities = viscosities_text(run.scene, run.summary); !viscosities.empty())
    table.rows.push_back({"shear viscosity, by trials", viscosities, "", "", ""});
  return table;
}

/// What the set state is to be compared with, reduced.
sdpd::SetState set_state(RunResult const& run) {
  auto const& settings = run.settings;
  auto const* const sdpd = std::get_if<sdpd::Sdpd>(&settings.method);
  if (!sdpd)
    return {};
  double const P = std::visit(
      [&](auto const& eos) { return fitting::state_from_temperature(eos, settings.rho, settings.T).P; },
      sdpd->eos);
  return {.P = P / settings.units().pressure()};
}

std::vector<std::string> texts_of(std::vector<sdpd::Finding> const& findings) {
  std::vector<std::string> texts;
  for (auto const& finding : findings)
    texts.push_back(finding.text);
  return texts;
}

Figure drawn(std::vector<Plot> const& plots, std::string caption) {
  Figure figure{{}, std::move(caption)};
  for (auto const& plot : plots)
    figure.svgs.push_back(draw_svg(plot));
  return figure;
}

Section time_section(std::filesystem::path const& run_file, RunResult const& run) {
  auto figure =
      drawn(time_series_plots(run_file, run),
            "The sampled part of the run (means of neighbouring samples where there are many); dashes "
            "and bands: the mean over the run ± its standard error, which knows the samples' memory.");
  Section section{"In time", {}};
  if (run.scene.features().energies) {
    figure.svgs.push_back(draw_svg(energy_error_plot("energyerror", {{"", &run}})));
    figure.caption += fmt::format(" The relative energy error drifts at {} per reduced unit of time.",
                                  with_error_text({run.equilibrium.drift.rate, run.equilibrium.drift.se, 8}));
  }
  section.content.emplace_back(std::move(figure));
  return section;
}

/// Distributions over the particles: those that the scene asks for, or of the stored instants.
std::vector<Plot> distributions(std::filesystem::path const& run_file, RunResult const& run) {
  if (auto asked = histogram_plots(run_file, run); !asked.empty())
    return asked;
  bool const si = run.scene.units == UnitSystem::SI;
  std::vector<Plot> plots;
  if (!run.eps.empty()) {
    auto const& units = run.settings.units();
    double const thermal = units.boltzmann * units.temperature;
    plots.push_back(
        distribution_plot("energies", "Internal energies", "eps / k_B T", {{"", run.eps, thermal}}));
  }
  if (!run.rho.empty())
    plots.push_back(
        distribution_plot("densities", "Densities", si ? "rho [kg/m^3]" : "rho", {{"", run.rho}}));
  if (!run.P.empty())
    plots.push_back(
        distribution_plot("pressures", "Pressures", si ? "P [GPa]" : "P", {{"", run.P, si ? 1e9 : 1}}));
  return plots;
}

/// The files that a run may leave in its folder, those that are there.
Files files_of(std::filesystem::path const& directory) {
  static std::vector<Files::Entry> const known{
      {"summary.json", "all results with their standard errors"},
      {"run.h5", "samples, instants, profiles and histograms (HDF5)"},
      {former_h5md_name, "positions and velocities (H5MD), of an earlier version"},
      {"trajectory.h5md", "positions, velocities and what particles have (H5MD)"},
      {"trajectory.vtkhdf", "the particles for ParaView 5.12 and later"},
      {"trajectory.hdf.series", "the same for ParaView 5.11"},
      {"trajectory.xyz", "the particles for OVITO"},
      {"calibration.json", "how the constants of the densities were found"},
      {"viscosity.json", "how the friction of pairs was found"},
      {"scene.toml", "the scene as resolved"},
      {"log.txt", "what the run said"}};
  Files files;
  for (auto const& entry : known)
    if (std::filesystem::exists(directory / entry.name))
      files.entries.push_back(entry);
  return files;
}

std::string lead_of(RunResult const& run, OutputUnits const& units) {
  auto const& method = sdpd::method_named(run.scene.method.name);
  return fmt::format(
      "{} {} particles{} with {:.1f} neighbours each, {} steps of {:.4g} reduced time units{} "
      "after {} steps of equilibration.",
      particles_of(run.scene), method.title,
      method.features.densities ? fmt::format(" of size K = {:g}", run.settings.K()) : "", run.neighbours,
      run.scene.run.steps, run.settings.dt,
      run.scene.units == UnitSystem::SI ? fmt::format(" ({:.4g} s)", run.settings.dt * units.time) : "",
      run.scene.run.equilibrate);
}

/// What the method of the run rests on.
std::vector<std::string> sources_of(RunResult const& run) {
  std::vector<std::string> sources;
  bool const densities = run.scene.features().densities;
  if (densities)
    sources = {"Espanol and Revenga 2003", "Faure et al. 2016"};
  if (densities && run.scene.particles.kernel.starts_with("wendland"))
    sources.emplace_back("Dehnen and Aly 2012");
  if (run.scene.scheme.name == "ssa")
    sources.emplace_back("Shardlow 2003");
  if (run.scene.fluid.eos == "argon" || run.scene.fluid.eos == "lj")
    sources.emplace_back("Johnson et al. 1993");
  if (run.scene.fluid.eos == "lj-kn")
    sources.emplace_back("Kolafa and Nezbeda 1994");
  if (run.scene.fluid.eos == "lj-thol")
    sources.emplace_back("Thol et al. 2016");
  sources.emplace_back("Wolff 2004");
  return sources;
}

/// What a run shows that is not at equilibrium: shock, start, exact solution, flow, space and time; and the
/// film.
std::vector<Section> driven_sections(std::filesystem::path const& run_file, RunResult const& run,
                                     OutputUnits const& units) {
  Store const store(run_file, Store::Mode::read);
  std::vector<Section> sections;
  if (auto const shock = shock_of(store, run.scene, run.settings))
    sections.push_back(shock_section(*shock, units));
  if (auto const detonation = detonation_of(store, run.scene, run.settings))
    sections.push_back(detonation_section(*detonation, run.scene, units));
  if (run.settings.layout)
    sections.push_back({"Start",
                        {drawn({start_picture(run.scene, run.settings)},
                               fmt::format("A layer through the middle of the box. {}.",
                                           fmt::join(region_lines(run.scene, run.settings), "; ")))}});
  if (auto const problem = riemann_problem(run.scene, run.settings))
    if (auto const found = compare(*problem, store, run.scene, units))
      sections.push_back(riemann_section(*found, units));
  if (auto const flow = flow_of(store, run.scene, run.settings))
    sections.push_back(flow_section(*flow, run));
  if (auto film = film_section(store, run.scene, run.settings))
    sections.push_back(std::move(*film));
  if (is_driven(run.scene))
    if (auto pictures = space_time_section(store, run.scene, units))
      sections.push_back(std::move(*pictures));
  return sections;
}

} // namespace

void write_equilibrium_report(std::filesystem::path const& file, RunResult const& run,
                              std::string const& command) {
  OutputUnits const units(run.settings.units(), run.scene.units);
  auto const directory = file.parent_path(), run_file = directory / "run.h5";
  Report report{.title = run.scene.title,
                .lead = lead_of(run, units),
                .verdicts = {},
                .sections = {},
                .provenance = {command, run.settings.seed, resolved_toml(run.scene), {}},
                .warnings = texts_of(run.findings),
                .sources = sources_of(run)};
  for (auto& section : driven_sections(run_file, run, units))
    report.sections.push_back(std::move(section));
  if (!is_driven(run.scene))
    report.sections.push_back({"Results", {numbers(run, units)}});
  report.sections.push_back(time_section(run_file, run));
  if (auto measured = measured_section(run_file, run, set_state(run)))
    report.sections.push_back(std::move(*measured));
  if (auto const profiles = profile_plots(run_file, run); !profiles.empty() && !is_driven(run.scene))
    report.sections.push_back(
        {"Profiles",
         {drawn(profiles,
                fmt::format("Across the box along {}, means over the run with their standard errors.",
                            run.scene.profile.axis))}});
  if (auto const shown = distributions(run_file, run); !shown.empty())
    report.sections.push_back({"Distributions", {drawn(shown, "Over particles and instants.")}});
  report.sections.push_back({"Files", {files_of(directory)}});
  write_text_file(file, report.html());
}

} // namespace mesobridge::workflows
