#include "workflows/report/report.hpp"
#include "fitting/eos/evaluate.hpp"
#include "workflows/lj_to_sdpd/chain.hpp"
#include "workflows/lj_to_sdpd/figures.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/equilibrium_plots.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::workflows {
namespace {

cg::Estimate scaled(cg::Estimate const& e, double unit) {
  return {e.mean * unit, e.se * unit, e.n_eff};
}

VerdictLine verdict(std::string what, bool passed, std::string found, std::string expected) {
  return {std::move(what), std::move(found), std::move(expected), passed ? Verdict::passed : Verdict::failed};
}

/// Within three standard errors, or 0.3 %, of one.
bool is_one(cg::Estimate const& T) {
  return std::abs(T.mean - 1) <= std::max(3 * T.se, 0.003);
}

std::vector<VerdictLine> verdicts(ChainResults const& results) {
  auto const independent = results.fit.difference_from_kolafa_nezbeda();
  auto const published = results.fit.difference_from_published();
  auto const in_its_range = results.fit.difference_from_published(fitting::LjBwrFit::published_T_max);
  std::vector<VerdictLine> lines;
  lines.push_back(verdict(
      "States predicted by a fit without them, U and P within 3 standard errors",
      results.fit.held_out_fraction >= 0.9,
      fmt::format("{:.0f} % of {} states", 100 * results.fit.held_out_fraction, results.fit.points.size()),
      "90 % or more"));
  auto add_difference = [&](std::string const& other, fitting::LjBwrFit::Difference const& d, bool asked) {
    bool const close = d.P <= 0.01 && d.U <= 0.005;
    lines.push_back({"Fit and " + other,
                     fmt::format("P differs by at most {:.2f} %, U by {:.2f} %", 100 * d.P, 100 * d.U),
                     "at most 1 % and 0.5 %",
                     close   ? Verdict::passed
                     : asked ? Verdict::failed
                             : Verdict::noted});
  };
  add_difference("Kolafa-Nezbeda equation of state (1994, valid to T* = 20), all sampled states", independent,
                 true);
  add_difference("published BWR set (1993), T* up to 6 as in its simulations", in_its_range, true);
  add_difference("published BWR set, all sampled states", published, false);
  for (auto const& run : results.ideal) {
    auto const test = gamma_test(run);
    auto const& e = run.equilibrium;
    lines.push_back(verdict(
        fmt::format("Ideal gas, K = {:g}: energies follow the Gamma law", run.settings.K),
        test.p_value > 0.001,
        fmt::format("Kolmogorov-Smirnov p = {:.3f}, {} samples", test.p_value, test.samples), "p > 0.001"));
    lines.push_back(verdict(
        fmt::format("Ideal gas, K = {:g}: kinetic and internal temperature", run.settings.K),
        is_one(e.T_kin) && is_one(e.T_int),
        with_error_text(scaled(e.T_kin, fluid_T)) + " K, " + with_error_text(scaled(e.T_int, fluid_T)) + " K",
        "1000 K within 3 standard errors or 0.3 %"));
  }
  for (auto const& run : results.fluid) {
    auto const& e = run.equilibrium;
    lines.push_back(verdict(
        fmt::format("Lennard-Jones fluid, K = {:g}: kinetic and internal temperature", run.settings.K),
        is_one(e.T_kin) && is_one(e.T_int),
        with_error_text(scaled(e.T_kin, fluid_T)) + " K, " + with_error_text(scaled(e.T_int, fluid_T)) + " K",
        "1000 K within 3 standard errors or 0.3 %"));
  }
  return lines;
}

Table fluid_table(ChainResults const& results) {
  auto const& first = results.fluid.front();
  auto const eos =
      std::visit([](auto const& model) { return fitting::state_from_temperature(model, fluid_rho, fluid_T); },
                 first.settings.eos);
  Table table{.header = {"K", "T kinetic [K]", "T internal [K]", "P virial [GPa]", "P thesis [GPa]",
                         "P / P EoS", "density [kg/m³]", "density thesis [kg/m³]", "drift [1/time]"},
              .rows = {},
              .caption = fmt::format(
                  "SDPD by the fitted equation of state, which gives {:.4f} GPa at 1000 K and 1150 kg/m³; "
                  "thesis: its Table 5.1.",
                  eos.P / 1e9)};
  for (auto const& run : results.fluid) {
    auto const& e = run.equilibrium;
    auto const thesis = thesis_means(run.settings.K);
    auto const P = scaled(e.P, run.settings.units().pressure() / 1e9);
    table.rows.push_back({number_text(run.settings.K), with_error_text(scaled(e.T_kin, fluid_T)),
                          with_error_text(scaled(e.T_int, fluid_T)), with_error_text(P),
                          number_text(thesis.pressure, 4), with_error_text(scaled(P, 1e9 / eos.P)),
                          with_error_text(scaled(e.rho.mean, fluid_rho)), number_text(thesis.density, 5),
                          with_error_text({e.drift.rate, e.drift.se, 8})});
  }
  return table;
}

Table published_table(ChainResults const& results) {
  Table table{.header = {"equation of state", "K", "P [GPa]", "T internal [K]", "density [kg/m³]"},
              .rows = {},
              .caption = "The same fluid by both equations of state: what the fit changes in SDPD."};
  auto add = [&](std::string const& name, RunResult const& run) {
    auto const& e = run.equilibrium;
    table.rows.push_back({name, number_text(run.settings.K),
                          with_error_text(scaled(e.P, run.settings.units().pressure() / 1e9)),
                          with_error_text(scaled(e.T_int, fluid_T)),
                          with_error_text(scaled(e.rho.mean, fluid_rho))});
  };
  for (auto const& run : results.published) {
    for (auto const& fitted : results.fluid)
      if (fitted.settings.K == run.settings.K)
        add("fitted", fitted);
    add("published", run);
  }
  return table;
}

Table state_table(fitting::LjBwrFit const& fit) {
  Table table{.header = {"rho*", "T*", "U* MD", "U* fit", "U* 1993", "U* held out [se]", "P* MD", "P* fit",
                         "P* 1993", "P* held out [se]"},
              .rows = {},
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
              .rows = {},
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

Figure figure(std::vector<Plot> const& plots, std::string caption) {
  Figure result{{}, std::move(caption)};
  for (auto const& plot : plots)
    result.svgs.push_back(draw_svg(plot));
  return result;
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
       Paragraph{"The published set rests on simulations up to T* = 6. Beyond, where SDPD at 1000 K (T* = "
                 "8.3) works, it "
                 "extrapolates: its energies fall below those of molecular dynamics by several per cent. The "
                 "equation of "
                 "Kolafa and Nezbeda (Fluid Phase Equilib. 100 (1994) 1) is valid up to T* = 20 and took no "
                 "part in the "
                 "fit: it is the independent witness."},
       figure({isotherms(results, GridQuantity::P)}, "Pressure. Below, relative to the fit: MD (points with "
                                                     "error bars), Kolafa-Nezbeda (lines), published "
                                                     "set (dashes)."),
       figure({isotherms(results, GridQuantity::U)},
              "Energy per atom. Differences are relative to max(|U*|, T*), since U* passes through zero."),
       figure({models_and_md(results, GridQuantity::P), models_and_md(results, GridQuantity::U)},
              "Published equations against each other and against this MD. The 1993 set was made from "
              "simulations up to T* = 6 and fails above; Thol et al. (J. Phys. Chem. Ref. Data 45 (2016) "
              "023101) "
              "hold to T* = 9."),
       figure({held_out(results)},
              fmt::format("Leave-one-out predictions: {:.0f} % of the states lie within 3 combined "
                          "standard errors in both U and P; rms deviation {:.2f}.",
                          100 * fit.held_out_fraction, fit.rms_held_out_deviation)),
       state_table(fit)}};
}

Section fluid_section(ChainResults const& results) {
  return {"SDPD of the Lennard-Jones fluid, by size",
          {Paragraph{"1000 particles at 1000 K and 1150 kg/m³, eta = 2e-3 Pa·s, cubic kernel with h = 2.5 "
                     "mean spacings, from "
                     "a disordered lattice. The equilibration takes out the difference between the mean "
                     "temperature and "
                     "the set one; the sampled part is microcanonical."},
           figure({pressure_against_size(results), temperatures_against_size(results),
                   density_against_size(results), variances_against_size(results)},
                  "Means and variances against the particle size; dashes: the thesis's Table 5.1."),
           Paragraph{"The particles leave out of their equation of state what their centres of mass carry, "
                     "so that the total energy does not depend on the size; the thesis's do not. Their "
                     "densities are plain sums over neighbours, which are not the mass per volume: particles "
                     "that repel each other are not where random ones are, and each counts itself. "
                     "`particles.density = \"calibrated\"` finds the constants that mend pressure and mean "
                     "density; `reproduce table-5.1` shows both."},
           fluid_table(results), published_table(results),
           figure(fluid_distributions(results), "Distributions over particles and instants.")}};
}

Section ideal_gas_section(ChainResults const& results) {
  return {
      "SDPD of the ideal gas: exact answers",
      {Paragraph{
           "The internal energy of an ideal-gas particle follows a Gamma law of shape (3/2)(K-1) exactly."},
       figure(ideal_gas_distributions(results), "Histograms and exact laws.")}};
}

Section drift_section(ChainResults const& results) {
  auto const laws = drift_laws(results.drift);
  std::vector<std::pair<std::string, RunResult const*>> curves;
  for (auto const& run : results.drift)
    if (run.settings.K == 100 && run.settings.dt >= 0.3)
      curves.emplace_back(fmt::format("K = 100, dt = {:g}", run.settings.dt), &run);
  return {
      "Energy drift of the splitting",
      {Paragraph{
           "Verlet and Shardlow's splitting each conserve energy in their own way, their composition drifts. "
           "The "
           "printed prefactors contradict the thesis's own choice dt = 0.13 for 0.5 % after 5e5 steps at K = "
           "10, "
           "which needs 7.7e-8 per unit of time where the printed law gives 1.4e-4: only the exponent can be "
           "compared. A power law is a summary over the range of dt shown, not an asymptotic order; the rate "
           "rises "
           "more steeply towards the limit of stability, so that the exponent depends on the range."},
       figure({drift_against_time_step(laws), energy_error_plot("energyerror", curves)},
              "Left: drift rates. Right: the energy error in time."),
       drift_table(laws)}};
}

Section cost_section(ChainResults const& results) {
  Table table{
      .header = {"stage", "seconds"}, .rows = {}, .caption = "Wall time of the stages on this machine."};
  table.rows = {{"molecular dynamics", number_text(results.seconds.md, 3)},
                {"analysis and fit", number_text(results.seconds.fit, 3)},
                {"SDPD", number_text(results.seconds.sdpd, 3)}};
  return {"Cost", {table}};
}

} // namespace

std::string chain_report(ChainResults const& results, Provenance const& provenance) {
  auto lines = verdicts(results);
  auto const passed = std::count_if(lines.begin(), lines.end(),
                                    [](auto const& line) { return line.verdict == Verdict::passed; });
  Report const report{.title = "From Lennard-Jones molecular dynamics to SDPD",
                      .lead =
                          fmt::format("LAMMPS sampled {} states of the Lennard-Jones fluid, a BWR equation "
                                      "of state was fitted to them, and "
                                      "SDPD ran with that fit at {} sizes. {} of {} checks passed.",
                                      results.fit.points.size(), results.fluid.size(), passed, lines.size()),
                      .verdicts = std::move(lines),
                      .sections = {fit_section(results), fluid_section(results), ideal_gas_section(results),
                                   drift_section(results), cost_section(results)},
                      .provenance = provenance};
  return report.html();
}

} // namespace mesobridge::workflows
