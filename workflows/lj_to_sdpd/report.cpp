#include "workflows/report/report.hpp"
#include "fitting/eos/evaluate.hpp"
#include "workflows/lj_to_sdpd/chain.hpp"
#include "workflows/lj_to_sdpd/checks.hpp"
#include "workflows/lj_to_sdpd/figures.hpp"
#include "workflows/report/drawn.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/equilibrium_plots.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

Table fluid_table(ChainResults const& results) {
  auto const& first = results.fluid.front();
  auto const eos =
      std::visit([](auto const& model) { return fitting::state_from_temperature(model, fluid_rho, fluid_T); },
                 first.settings.as<sdpd::Sdpd>().eos);
  Table table{.header = {"K", "T kinetic [K]", "T internal [K]", "P virial [GPa]", "P thesis [GPa]",
                         "P / P EoS", "density [kg/m³]", "density thesis [kg/m³]", "drift [1/time]"},
              .caption = fmt::format(
                  "SDPD by the fitted equation of state, which gives {:.4f} GPa at 1000 K and 1150 kg/m³; "
                  "thesis: its Table 5.1.",
                  eos.P / 1e9)};
  for (auto const& run : results.fluid) {
    auto const& e = run.equilibrium;
    auto const thesis = thesis_means(run.settings.K());
    auto const P = scaled(e.P, run.settings.units().pressure() / 1e9);
    table.rows.push_back({number_text(run.settings.K()), with_error_text(scaled(e.T_kin, fluid_T)),
                          with_error_text(scaled(e.T_int, fluid_T)), with_error_text(P),
                          number_text(thesis.pressure, 4), with_error_text(scaled(P, 1e9 / eos.P)),
                          with_error_text(scaled(e.rho.mean, fluid_rho)), number_text(thesis.density, 5),
                          with_error_text({e.drift.rate, e.drift.se, 8})});
  }
  return table;
}

Table published_table(ChainResults const& results) {
  Table table{.header = {"equation of state", "K", "P [GPa]", "T internal [K]", "density [kg/m³]"},
              .caption = "The same fluid by both equations of state: what the fit changes in SDPD."};
  auto add = [&](std::string const& name, RunResult const& run) {
    auto const& e = run.equilibrium;
    table.rows.push_back({name, number_text(run.settings.K()),
                          with_error_text(scaled(e.P, run.settings.units().pressure() / 1e9)),
                          with_error_text(scaled(e.T_int, fluid_T)),
                          with_error_text(scaled(e.rho.mean, fluid_rho))});
  };
  for (auto const& run : results.published) {
    for (auto const& fitted : results.fluid)
      if (fitted.settings.K() == run.settings.K())
        add("fitted", fitted);
    add("published", run);
  }
  return table;
}

Table state_table(fitting::LjBwrFit const& fit) {
  Table table{.header = {"rho*", "T*", "U* MD", "U* fit", "U* 1993", "U* held out [se]", "P* MD", "P* fit",
                         "P* 1993", "P* held out [se]"},
              .caption = "Every state, per atom in Lennard-Jones units; ‘held out’: MD minus the prediction "
                         "by a fit without "
                         "this state, in their combined standard error."};
  for (auto const& p : fit.points)
    table.rows.push_back({number_text(p.rho, 4), number_text(p.T, 4), with_error_text({p.U, p.U_se, 0}),
                          number_text(p.U_fit, 6), number_text(p.U_published, 6),
                          fmt::format("{:+.1f}", p.U_held_out_deviation), with_error_text({p.P, p.P_se, 0}),
                          number_text(p.P_fit, 6), number_text(p.P_published, 6),
                          fmt::format("{:+.1f}", p.P_held_out_deviation)});
  return table;
}

Table drift_table(std::vector<DriftLaw> const& laws) {
  Table table{.header = {"K", "rates used", "exponent", "printed exponent", "prefactor", "printed prefactor"},
              .caption = "Power laws alpha = C dt^n through the drift rates, in reduced units."};
  for (auto const& law : laws) {
    bool const fitted = law.exponent.n_eff > 0;
    table.rows.push_back({number_text(law.K), fmt::format("{} of {}", law.used, law.dt.size()),
                          fitted ? with_error_text(law.exponent) : "-", "5.44",
                          fitted ? with_error_text(law.prefactor) : "-",
                          law.K == 10   ? "9.50"
                          : law.K == 50 ? "181"
                                        : "217"});
  }
  return table;
}

Paragraph accuracy_paragraph(fitting::LjBwrFit const& fit) {
  auto const accuracy = published_accuracy(fit.points);
  return {fmt::format(
      "How far a published equation can be trusted is taken from the two themselves: they were "
      "fitted to different simulations, and differ at the sampled states up to T* = 9 by {:.2f} % in "
      "P and {:.2f} % in U (rms; of T* where U is smaller), for which either may be the reason. The "
      "MD's own errors hold 0.1 % for the time step, 500 atoms and the cut-off, beside the "
      "statistical one.",
      100 * accuracy.P, 100 * accuracy.U)};
}

Paragraph prior_paragraph(fitting::LjBwrFit const& fit) {
  auto const in_its_range = fit.difference_from_published(fitting::LjBwrFit::published_T_max),
             everywhere = fit.difference_from_published();
  return {fmt::format(
      "The BWR set of Johnson et al. (1993), from which the fit starts, rests on simulations up to "
      "T* = 6, few of them hot and dense. From the fit it differs by up to {:.1f} % in P and {:.1f} % "
      "in U there, and by up to {:.1f} % and {:.1f} % at all sampled states, to which SDPD at 1000 K "
      "(T* = 8.3) belongs: so it is shown, and no check asks for it.",
      100 * in_its_range.P, 100 * in_its_range.U, 100 * everywhere.P, 100 * everywhere.U)};
}

Section fit_section(ChainResults const& results) {
  auto const& fit = results.fit;
  return {
      "From molecular dynamics to the equation of state",
      {Paragraph{"LAMMPS sampled " + std::to_string(fit.points.size()) +
                 " states: " + results.md_description + "."},
       Paragraph{fmt::format("So few states cannot determine the 32 linear parameters of the BWR equation: "
                             "of them the data determine {:.1f}. "
                             "The fit therefore starts from the published set of 1993 and corrects it; the "
                             "prior's relative width in U "
                             "and P, {:.2g}, is the one of largest evidence. Condition number of the data "
                             "alone {:.2g}, with the prior "
                             "{:.2g}; chi² = {:.1f} for {:.1f} degrees of freedom. Stable (c_v > 0, c² > 0) "
                             "for rho* = {:g} … {:g}, "
                             "T* = {:.3g} … {:g}.",
                             fit.effective_parameters, fit.prior_width, fit.condition,
                             fit.condition_regularised, fit.chi_2, fit.degrees_of_freedom,
                             fit.checked.rho_min, fit.checked.rho_max, fit.checked.T_min, fit.checked.T_max)},
       Paragraph{
           "The witnesses of MD and fit are two published equations that took no part in it: those of "
           "Kolafa and Nezbeda (1994), valid up to T* = 20, and of Thol et al. (2016), fitted up to T* = 9."},
       accuracy_paragraph(fit), prior_paragraph(fit),
       drawn({isotherms(results, GridQuantity::P), isotherms(results, GridQuantity::U)},
             "Pressure, and energy per atom. Below, relative to the fit: MD (points with error bars), "
             "Kolafa and "
             "Nezbeda (lines), the set of 1993 (dashes); of energies relative to max(|U*|, T*), since U* "
             "passes "
             "through zero."),
       drawn({models_and_md(results, GridQuantity::P), models_and_md(results, GridQuantity::U)},
             "Published equations against each other and against this MD. The 1993 set was made from "
             "simulations up to T* = 6; Thol et al. (2016) hold to T* = 9."),
       drawn({held_out(results)},
             fmt::format("Leave-one-out predictions: {:.0f} % of the states lie within 3 combined "
                         "standard errors in both U and P; rms deviation {:.2f}.",
                         100 * fit.held_out_fraction, fit.rms_held_out_deviation)),
       state_table(fit)}};
}

Section fluid_section(ChainResults const& results) {
  return {
      "SDPD of the Lennard-Jones fluid, by size",
      {Paragraph{"1000 particles at 1000 K and 1150 kg/m³, eta = 2e-3 Pa·s, kernel Wendland C4 with h = "
                 "2.5 mean spacings, which does not let particles pair, from a disordered lattice. The "
                 "equilibration takes out the difference between the mean temperature and the set one; the "
                 "sampled part is microcanonical."},
       Paragraph{"The densities are calibrated: two constants for each size, found on a run of its own, "
                 "make the mean density and the pressure those of the equation of state. The checks compare "
                 "with the equation of state ± the statistical error of that calibration and 0.1 % for the "
                 "structure of large particles, which settles slowly; temperatures with the set one ± 0.1 % "
                 "for the time step and the equilibration."},
       drawn(
           {pressure_against_size(results), temperatures_against_size(results), density_against_size(results),
            variances_against_size(results)},
           "Means and variances against the particle size; dashes: the thesis's Table 5.1 (Faure 2017), with "
           "plain densities."),
       Paragraph{"The particles leave out of their equation of state what their centres of mass carry, "
                 "so that the total energy does not depend on the size. The thesis's particles keep it, have "
                 "a cubic kernel and plain sums as densities, which are not the mass per volume: its "
                 "pressures and densities depend on the size. `reproduce table-5.1` shows both."},
       fluid_table(results), published_table(results),
       drawn(fluid_distributions(results), "Distributions over particles and instants.")}};
}

Section ideal_gas_section(ChainResults const& results) {
  return {
      "SDPD of the ideal gas: exact answers",
      {Paragraph{
           "The internal energy of an ideal-gas particle follows a Gamma law of shape (3/2)(K-1) exactly, "
           "whatever kernel and densities."},
       drawn(ideal_gas_distributions(results), "Histograms and exact laws.")}};
}

Section drift_section(ChainResults const& results) {
  auto const laws = drift_laws(results.drift);
  std::vector<std::pair<std::string, RunResult const*>> curves;
  for (auto const& run : results.drift)
    if (run.settings.K() == 100 && run.settings.dt >= 0.3)
      curves.emplace_back(fmt::format("K = 100, dt = {:g}", run.settings.dt), &run);
  return {
      "Energy drift of the splitting",
      {Paragraph{
           "These runs have the thesis's cubic kernel and plain densities. Verlet and Shardlow's splitting "
           "each conserve energy in their own way, their composition drifts. "
           "The "
           "printed prefactors contradict the thesis's own choice dt = 0.13 for 0.5 % after 5e5 steps at K = "
           "10, "
           "which needs 7.7e-8 per unit of time where the printed law gives 1.4e-4: only the exponent can be "
           "compared. A power law is a summary over the range of dt shown, not an asymptotic order; the rate "
           "rises "
           "more steeply towards the limit of stability, so that the exponent depends on the range."},
       drawn({drift_against_time_step(laws), energy_error_plot("energyerror", curves)},
             "Left: drift rates. Right: the energy error in time."),
       drift_table(laws)}};
}

Section cost_section(ChainResults const& results) {
  Table table{.header = {"stage", "seconds"}, .caption = "Wall time of the stages on this machine."};
  table.rows = {{"molecular dynamics", number_text(results.seconds.md, 3)},
                {"analysis and fit", number_text(results.seconds.fit, 3)},
                {"SDPD", number_text(results.seconds.sdpd, 3)}};
  return {"Cost", {table}};
}

} // namespace

std::string chain_report(ChainResults const& results, Provenance const& provenance) {
  auto lines = chain_checks(results);
  auto const failed = std::ranges::count(lines, Verdict::failed, &VerdictLine::verdict);
  auto const asked = failed + std::ranges::count(lines, Verdict::passed, &VerdictLine::verdict);
  Report const report{
      .title = "From Lennard-Jones molecular dynamics to SDPD",
      .lead = fmt::format(
          "LAMMPS sampled {} states of the Lennard-Jones fluid, a BWR equation of state was fitted "
          "to them, and SDPD ran with that fit at {} sizes. {}",
          results.fit.points.size(), results.fluid.size(),
          failed == 0 ? fmt::format("All {} checks passed.", asked)
                      : fmt::format("{} of {} checks failed.", failed, asked)),
      .verdicts = std::move(lines),
      .sections = {fit_section(results), fluid_section(results), ideal_gas_section(results),
                   drift_section(results), cost_section(results)},
      .provenance = provenance,
      .sources = {"Dehnen and Aly 2012", "Espanol and Revenga 2003", "Faure 2017", "Faure et al. 2016",
                  "Gronbech-Jensen and Farago 2013", "Johnson et al. 1993", "Kolafa and Nezbeda 1994",
                  "Shardlow 2003", "Thol et al. 2016", "Thompson et al. 2022", "Wolff 2004"}};
  return report.html();
}

} // namespace mesobridge::workflows
