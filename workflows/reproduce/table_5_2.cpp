#include "fitting/eos/list.hpp"
#include "md/units.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/lj/sample_piston.hpp"
#include "workflows/ranks.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/published.hpp"
#include "workflows/shock_study/shock_tables.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr double rho = 1150, T = 500, v_P = 500; // SI
constexpr double thin = 1e-4, thick = 2e-3;      // viscosities of figures 5.5 and 5.6 [Pa s]
constexpr double goal = 0.01;
constexpr char const* calibrated = "SDPD";
constexpr char const* plain_sums = "SDPD, plain densities";

struct Size {
  std::array<std::int64_t, 3> lattice;
  std::int64_t equilibrate;
  std::vector<double> K;
};

Size size_of(md::Preset preset) {
  std::vector<double> const printed{10, 100, 500, 1000, 5000, 10000};
  switch (preset) {
  case md::Preset::quick:
    return {{7, 7, 130}, 500, {10, 100, 1000, 10000}};
  case md::Preset::standard:
    return {{10, 10, 212}, 1000, printed};
  case md::Preset::paper:
    break;
  }
  return {{16, 16, 212}, 2000, printed}; // the thesis's
}

/// SSA leads an energy below zero now and then where particles are small; EMS does not.
std::string scheme_of(double K) {
  return K < 50 ? "ems" : "ssa";
}

ShockCase case_of(std::string const& model, double K, double eta, ReproduceOptions const& options) {
  auto const size = size_of(options.preset);
  return {fmt::format("{}-K{:g}-eta{:g}", model == calibrated ? "calibrated" : "plain", K, eta), model,
          piston_scene({.eos = "argon",
                        .rho = rho,
                        .T = T,
                        .v_P = v_P,
                        .K = K,
                        .eta = eta,
                        .dt = 0.02,
                        .scheme = scheme_of(K),
                        .lattice = size.lattice,
                        .equilibrate = size.equilibrate,
                        .seed = options.seed,
                        .as_in_the_thesis = model == plain_sums})};
}

/// Calibrated densities at every size and these viscosities; at the first of them the thesis's plain sums,
/// too (the quick preset: of one size).
std::vector<ShockCase> cases_of(std::vector<double> const& viscosities, ReproduceOptions const& options) {
  std::vector<ShockCase> cases;
  for (double const eta : viscosities)
    for (double const K : size_of(options.preset).K)
      cases.push_back(case_of(calibrated, K, eta, options));
  auto const plain =
      options.preset == md::Preset::quick ? std::vector<double>{100} : size_of(options.preset).K;
  for (double const K : plain)
    cases.push_back(case_of(plain_sums, K, viscosities.front(), options));
  return cases;
}

/// Molecular dynamics of the same piston, on ranks of its own: MPI stays out of this process. What a finished
/// run of these settings has left is read; nothing where the shock is not steady.
std::optional<ShockRow> molecular_dynamics(ReproduceOptions const& options, Context const& context) {
  auto settings = argon_piston(options.preset, rho, T, v_P);
  settings.seed = options.seed;
  PistonJob const job{.settings = settings, .directory = options.directory / "md"};
  std::error_code ignored;
  std::filesystem::create_directories(job.directory, ignored); // writing there says what is wrong
  auto const there = [&] {
    auto data = read_piston(job.file());
    return data.complete && data.description == settings.description() ? std::optional(std::move(data))
                                                                       : std::nullopt;
  };
  std::optional<PistonData> data;
  if (std::filesystem::exists(job.file()))
    data = there();
  if (!data) {
    std::vector<std::string> words{"md",
                                   "piston-shock",
                                   "--preset",
                                   name_of(options.preset),
                                   "--seed",
                                   std::to_string(options.seed),
                                   "-o",
                                   job.directory.string(),
                                   "--started-by-ourselves"};
    if (context.options.quiet)
      words.push_back("--quiet");
    run_on_ranks(ranks_of(context), words);
    throw_if_interrupted();
    data = there();
  }
  auto const shock = data ? shock_in(shock_data_of(*data)) : std::nullopt;
  return shock ? std::optional(md_row(*data, *shock)) : std::nullopt;
}

std::string printed_row(ShockRow const& row) {
  return row.model == "MD" ? "MD" : row.eta == thin ? fmt::format("{:g}", row.K) : "";
}

std::vector<ShockRow> of_model(std::vector<ShockRow> const& rows, std::string const& model, double eta) {
  std::vector<ShockRow> found;
  std::ranges::copy_if(rows, std::back_inserter(found),
                       [&](auto const& row) { return row.model == model && row.eta == eta; });
  return found;
}

std::vector<ShownRow> shown(std::vector<ShockRow> const& rows) {
  std::vector<ShownRow> list;
  for (auto const& row : rows)
    list.push_back({row.model == "MD" ? "MD" : fmt::format("K = {:g}", row.K), row, printed_row(row)});
  return list;
}

Figure front_figure(std::string const& name, std::vector<ShockRow> const& rows, double eta,
                    fitting::Shock const& exact) {
  auto of_eta = of_model(rows, calibrated, eta);
  for (auto const& row : rows)
    if (row.model == "MD")
      of_eta.push_back(row);
  auto const profile =
      fitting::shock_profile(fitting::Fluid(fitting::material("argon").eos), exact, {.shear_viscosity = eta});
  double const of_an_atom = std::cbrt(argon_units.mass / rho);
  auto const draw = [&](std::string const& suffix, std::optional<double> spacing) {
    return draw_svg(front_plot(name + suffix,
                               fmt::format("Density in the frame of the front, eta = {:g} Pa s", eta),
                               shown(of_eta), profile, exact, spacing));
  };
  return {{draw("reduced", of_an_atom), draw("nm", std::nullopt)},
          fmt::format(
              "Means of the particles' densities over the frames at eta = {:g} Pa s, in the mean distance "
              "between particles (that of atoms for MD and Navier-Stokes, as in the thesis) and in "
              "nanometres; the levels are the states ahead and behind by Rankine and Hugoniot.",
              eta)};
}

std::string lead_of(std::vector<NamedShock> const& exact) {
  return fmt::format("Argon of 1150 kg/m^3 and 500 K before a piston at 500 m/s, ours beside the thesis's "
                     "Table 5.2. Its walls "
                     "are layers of fixed particles, ours mirrors whose piston is ramped over 8 l/v_S (with "
                     "plain densities, as in the thesis, it starts at once). The "
                     "equations of state "
                     "do not agree: the BWR of 1993, which the particles have, is extrapolated above T* = 6 "
                     "and says {:.1f} K "
                     "behind the front, Kolafa and Nezbeda's {:.1f} K and Thol's {:.1f} K.",
                     exact[0].shock.behind.T, exact[1].shock.behind.T, exact[2].shock.behind.T);
}

Reproduced reproduce(std::string const& title, std::vector<double> const& viscosities,
                     ReproduceOptions const& options, Context const& context) {
  auto exact = argon_shocks(rho, T, v_P);
  if (options.fit) // bad input is told before hours of work
    exact.push_back(fitted_argon_shock(*options.fit, rho, T, v_P));
  auto rows = run_shocks(title, cases_of(viscosities, options), options, context);
  if (auto const row = molecular_dynamics(options, context))
    rows.insert(rows.begin(), *row);
  auto const printed = published("thesis-table-5.2.csv");
  ShockRow const* const md = rows.front().model == "MD" ? &rows.front() : nullptr;
  Reproduced found;
  for (auto const& row : rows)
    found.summary["rows"].push_back(row_json(row, printed, printed_row(row)));
  found.summary["rankine_hugoniot"] = shock_json(exact.front().shock);
  found.summary["rankine_hugoniot_by_equation"] = equations_json(md, exact);
  auto& report = found.report;
  report.title = title;
  report.lead = lead_of(exact);
  for (double const eta : viscosities)
    for (auto& line : shock_verdicts(of_model(rows, calibrated, eta), exact.front().shock, goal,
                                     fmt::format("calibrated, eta = {:g} Pa s", eta)))
      report.verdicts.push_back(std::move(line));
  report.sections.push_back(
      {"States behind the front",
       {shock_table(shown(rows), exact, printed,
                    "rho: mean of the particles' densities, as printed; mass/volume: what the slices hold. "
                    "R.-H.: by the relations of Rankine and Hugoniot. Re_l = rho_0 v_S l/(4 eta/3 + zeta): "
                    "above 2 the state behind the front ripples."),
        Paragraph{printed.source},
        Paragraph{"Where Re_l is large the particles cannot turn the work of the front into heat at once: a "
                  "part of "
                  "it stays in the ripples and in motion within the slices (T_kin above the internal T). It "
                  "is missing "
                  "in T and in P, which is then less than the momentum that the front carries, P_0 + rho_0 "
                  "v_S v_P, and "
                  "the front is faster."}}});
  report.sections.push_back(equations_section(md, exact));
  for (double const eta : viscosities)
    report.sections.push_back(
        {eta == thin ? "Figure 5.5" : "Figure 5.6",
         {front_figure(eta == thin ? "thin" : "thick", rows, eta, exact.front().shock)}});
  report.sources = {"Faure 2017", "Johnson et al. 1993", "Kolafa and Nezbeda 1994", "Thol et al. 2016",
                    "Thompson et al. 2022"};
  return found;
}

} // namespace

Reproduced reproduce_table_5_2(ReproduceOptions const& options, Context const& context) {
  return reproduce("Table 5.2: a shock in Lennard-Jones argon", {thin, thick}, options, context);
}

Reproduced reproduce_figure_5_5(ReproduceOptions const& options, Context const& context) {
  return reproduce("Figure 5.5: density through the front, 1e-4 Pa s", {thin}, options, context);
}

Reproduced reproduce_figure_5_6(ReproduceOptions const& options, Context const& context) {
  return reproduce("Figure 5.6: density through the front, 2e-3 Pa s", {thick}, options, context);
}

} // namespace mesobridge::workflows
