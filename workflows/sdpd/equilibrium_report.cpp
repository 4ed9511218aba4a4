#include "workflows/sdpd/equilibrium_report.hpp"
#include "fitting/eos/evaluate.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/equilibrium_plots.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

cg::Estimate scaled(cg::Estimate const& e, double unit) {
  return {e.mean * unit, e.se * unit, e.n_eff};
}

std::string with_unit(std::string const& quantity, std::string const& unit) {
  return unit.empty() ? quantity : quantity + " [" + unit + "]";
}

Table numbers(RunResult const& run, OutputUnits const& units) {
  auto const& e = run.equilibrium;
  bool const si = run.scene.units == UnitSystem::SI;
  auto const state = std::visit(
      [&](auto const& eos) { return fitting::state_from_temperature(eos, run.settings.rho, run.settings.T); },
      run.settings.eos);
  Table table{.header = comparison_header(),
              .rows = {},
              .caption = "Means over the run beside the equation of state at the "
                         "set density and temperature."};
  table.rows.push_back(comparison_row(with_unit("kinetic temperature", si ? "K" : ""),
                                      scaled(e.T_kin, units.temperature), run.settings.T));
  table.rows.push_back(comparison_row(with_unit("internal temperature", si ? "K" : ""),
                                      scaled(e.T_int, units.temperature), run.settings.T));
  table.rows.push_back(
      comparison_row(with_unit("pressure", si ? "Pa" : ""), scaled(e.P, units.pressure), state.P));
  table.rows.push_back(comparison_row(with_unit("mean density", si ? "kg/m^3" : ""),
                                      scaled(e.rho.mean, units.density), state.rho));
  return table;
}

/// Means of a DPD or DPDE run: for its pressure there is nothing to compare with.
Table pair_fluid_numbers(RunResult const& run, OutputUnits const& units) {
  auto const& e = run.equilibrium;
  bool const si = run.scene.units == UnitSystem::SI;
  Table table{
      .header = comparison_header(), .rows = {}, .caption = "Means over the run beside the set temperature."};
  table.rows.push_back(comparison_row(with_unit("kinetic temperature", si ? "K" : ""),
                                      scaled(e.T_kin, units.temperature), run.settings.T));
  if (run.settings.pair_fluid->follows_energy())
    table.rows.push_back(comparison_row(with_unit("internal temperature (harmonic mean)", si ? "K" : ""),
                                        scaled(e.T_int, units.temperature), run.settings.T));
  table.rows.push_back(
      {with_unit("pressure", si ? "Pa" : ""), with_error_text(scaled(e.P, units.pressure)), "", "", ""});
  return table;
}

void write_pair_fluid_report(std::filesystem::path const& file, RunResult const& run,
                             std::string const& command) {
  OutputUnits const units(run.settings.units(), run.scene.units);
  bool const energies = run.settings.pair_fluid->follows_energy();
  double const thermal = run.settings.units().energy();
  Report report{.title = run.scene.title,
                .lead = fmt::format(
                    "{} {} particles with {:.1f} neighbours each, {} steps of {:.4g} reduced time units "
                    "after {} steps of equilibration.",
                    run.scene.particles.N, energies ? "DPDE" : "DPD", run.neighbours, run.scene.run.steps,
                    run.settings.dt, run.scene.run.equilibrate),
                .verdicts = {},
                .sections = {{"Means", {pair_fluid_numbers(run, units)}}},
                .provenance = {command, run.settings.seed, resolved_toml(run.scene), {}}};
  if (energies) {
    auto const distribution =
        draw_svg(distribution_plot("energies", "Internal energies", "eps / k_B T", {{"", run.eps, thermal}}));
    report.sections.push_back({"Distributions", {Figure{{distribution}, "Over particles and instants."}}});
    report.sections.push_back(
        {"Conservation of energy",
         {Figure{{draw_svg(energy_error_plot("energy_error", {{"", &run}}))},
                 fmt::format("Relative energy error; it drifts at {} per reduced unit of time.",
                             with_error_text({run.equilibrium.drift.rate, run.equilibrium.drift.se, 8}))}}});
  }
  write_text_file(file, report.html());
}

} // namespace

void write_equilibrium_report(std::filesystem::path const& file, RunResult const& run,
                              std::string const& command) {
  if (run.settings.pair_fluid)
    return write_pair_fluid_report(file, run, command);
  OutputUnits const units(run.settings.units(), run.scene.units);
  bool const si = run.scene.units == UnitSystem::SI;
  double const thermal = run.settings.units().boltzmann * run.settings.T;
  double const GPa = si ? 1e9 : 1;
  std::vector<std::string> const distributions{
      draw_svg(distribution_plot("energies", "Internal energies", "eps / k_B T", {{"", run.eps, thermal}})),
      draw_svg(distribution_plot("densities", "Densities", si ? "rho [kg/m^3]" : "rho", {{"", run.rho}})),
      draw_svg(distribution_plot("pressures", "Pressures", si ? "P [GPa]" : "P", {{"", run.P, GPa}}))};
  Report report{
      .title = run.scene.title,
      .lead = fmt::format(
          "{} SDPD particles of size K = {:g} with {:.1f} neighbours each, {} steps of {:.4g} reduced "
          "time units ({:.4g}{}) after {} steps of equilibration.",
          run.scene.particles.N, run.settings.K, run.neighbours, run.scene.run.steps, run.settings.dt,
          run.settings.dt * units.time, si ? " s" : "", run.scene.run.equilibrate),
      .verdicts = {},
      .sections = {{"Means", {numbers(run, units)}},
                   {"Distributions", {Figure{distributions, "Distributions over particles and instants."}}},
                   {"Conservation of energy",
                    {Figure{{draw_svg(energy_error_plot("energy_error", {{"", &run}}))},
                            fmt::format("Relative energy error; it drifts at {} per reduced unit of time.",
                                        with_error_text(
                                            {run.equilibrium.drift.rate, run.equilibrium.drift.se, 8}))}}}},
      .provenance = {command, run.settings.seed, resolved_toml(run.scene), {}}};
  write_text_file(file, report.html());
}

} // namespace mesobridge::workflows
