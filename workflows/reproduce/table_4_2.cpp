#include "fitting/eos/list.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/published.hpp"
#include "workflows/shock_study/shock_tables.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr double rho = 1150, T = 1000, v_P = 1661, K = 5, eta = 2e-3; // SI
constexpr double goal = 0.01;

/// Where the constants of the densities come from.
struct Densities {
  std::string name;   ///< of a run's folder
  std::string suffix; ///< of a row's model
  std::string key;    ///< as scenes have it; empty: the thesis's plain sums
};
Densities const plain{"", "", ""}, at_rest{"-calibrated", ", calibrated at rest", "calibrated"},
    behind{"-shocked", ", calibrated behind the front", "calibrated-shocked"};

struct Size {
  std::array<std::int64_t, 3> lattice;
  std::int64_t equilibrate;
};

/// The thesis equilibrates over 50 units of time.
Size size_of(md::Preset preset) {
  return preset == md::Preset::quick ? Size{{7, 7, 200}, 400} : Size{{10, 10, 234}, 1111};
}

ShockCase case_of(std::string const& scheme, double dt, Densities const& densities,
                  ReproduceOptions const& options) {
  auto const size = size_of(options.preset);
  std::string model = scheme;
  std::ranges::transform(model, model.begin(), [](unsigned char c) { return std::toupper(c); });
  bool const as_in_the_thesis = densities.key.empty();
  return {fmt::format("{}{}-dt{:g}", scheme, densities.name, dt), model + densities.suffix,
          piston_scene({.eos = "ideal-gas",
                        .rho = rho,
                        .T = T,
                        .v_P = v_P,
                        .K = K,
                        .eta = eta,
                        .dt = dt,
                        .scheme = scheme,
                        .lattice = size.lattice,
                        .equilibrate = size.equilibrate,
                        .seed = options.seed,
                        .as_in_the_thesis = as_in_the_thesis,
                        .density = as_in_the_thesis ? "auto" : densities.key})};
}

std::vector<ShockCase> cases_of(ReproduceOptions const& options, bool with_ssa) {
  constexpr double dt = 0.045,
                   smallest = 1e-4; // the thesis's, and the smallest at which it says that SSA fails
  std::vector<ShockCase> cases;
  for (std::string const scheme : {"ems", "ams"})
    for (auto const& densities : {plain, at_rest, behind})
      cases.push_back(case_of(scheme, dt, densities, options));
  if (with_ssa) {
    cases.push_back(case_of("ssa", dt, plain, options));
    auto const like = cases.back().scene;
    cases.push_back(case_of("ssa", smallest, plain, options));
    auto& scene = cases.back().scene; // of as many steps: failures are said to come early
    scene.run.steps = like.run.steps, scene.run.sample_every = like.run.sample_every;
    scene.profile.every = like.profile.every;
  }
  return cases;
}

std::string printed_row(ShockRow const& row) {
  return row.model == "EMS" ? "ems" : row.model == "AMS" ? "ams" : "";
}

std::vector<NamedShock> exact_shock() {
  fitting::Fluid const gas(fitting::material("ideal-gas").eos);
  return {{"ideal-gas", "ideal gas", fitting::Hugoniot(gas, gas.at_temperature(rho, T)).from_piston(v_P)}};
}

std::vector<ShownRow> shown(std::vector<ShockRow> const& rows) {
  std::vector<ShownRow> list;
  for (auto const& row : rows)
    list.push_back({row.model, row, printed_row(row)});
  return list;
}

/// What became of SSA: where it ended (particle, step and cause, in the engine's own words), or that it did
/// not.
Table ssa_table(std::vector<ShockRow> const& rows) {
  Table table{
      .header = {"scheme", "dt", "what became of it"},
      .caption =
          "The thesis could not use SSA here: negative energies appeared very early even at dt = 1e-4."};
  for (auto const& row : rows)
    if (row.model == "SSA")
      table.rows.push_back({row.model, fmt::format("{:g}", row.dt_reduced),
                            row.failed() ? row.failure : "went through, no energy turned negative"});
  return table;
}

Reproduced reproduce(std::string const& title, bool with_ssa, ReproduceOptions const& options,
                     Context const& context) {
  auto const rows = run_shocks(title, cases_of(options, with_ssa), options, context);
  auto const printed = published("thesis-table-4.2.csv");
  auto const exact = exact_shock();
  Reproduced found;
  for (auto const& row : rows)
    found.summary["rows"].push_back(row_json(row, printed, printed_row(row)));
  found.summary["rankine_hugoniot"] = shock_json(exact.front().shock);
  std::vector<ShockRow> judged, finished;
  for (auto const& row : rows) {
    if (row.model.ends_with(behind.suffix))
      judged.push_back(row);
    if (!row.failed())
      finished.push_back(row);
  }
  auto const profile = fitting::shock_profile(fitting::Fluid(fitting::material("ideal-gas").eos),
                                              exact.front().shock, {.shear_viscosity = eta});
  found.report = {
      .title = title,
      .lead =
          "The thesis's ideal gas (1150 kg/m^3, 1000 K, eta = 2e-3 Pa s) in particles of K = 5 before a "
          "piston at 1661 m/s, dt = 0.045, with the thesis's plain densities and with densities calibrated "
          "at rest and behind the front. Its walls are layers of fixed particles, ours mirrors. The 8244 K "
          "that it prints for Rankine and Hugoniot do not follow from its own pressure and density, which "
          "give 8140 K.",
      .verdicts = shock_verdicts(judged, exact.front().shock, goal, "densities calibrated behind the front"),
      .sections =
          {{"States behind the front",
            {shock_table(
                 shown(finished), exact, printed,
                 "rho: mean of the particles' densities, as printed; mass/volume: what the slices hold. "
                 "R.-H.: by the relations of Rankine and Hugoniot."),
             Paragraph{printed.source},
             Paragraph{
                 "Constants of the densities that were found at rest keep the pressure that the fluid "
                 "exerts right at 3.5 times the density too, and with it v_S and the mass per volume; but "
                 "not the densities that the particles themselves have, nor the means of their own "
                 "pressures, which the table shows (sdpd/README.md, Eq. (S70) ... (S72)). Constants that "
                 "were found in the state behind the front (particles.density = \"calibrated-shocked\") "
                 "make these right there, and leave the particles' densities about 2 % too small at rest "
                 "(S71)."}}},
           {"Figure 4.10",
            {Figure{{draw_svg(front_plot("front", "Density in the frame of the front", shown(finished),
                                         profile, exact.front().shock, rows.front().spacing))},
                    "Means of the particles' densities over the frames; the levels are the states ahead and "
                    "behind by Rankine and Hugoniot."}}}},
      .provenance = {}};
  if (with_ssa)
    found.report.sections.push_back({"SSA", {ssa_table(rows)}});
  return found;
}

} // namespace

Reproduced reproduce_table_4_2(ReproduceOptions const& options, Context const& context) {
  return reproduce("Table 4.2: a shock in an ideal gas", true, options, context);
}

Reproduced reproduce_figure_4_10(ReproduceOptions const& options, Context const& context) {
  return reproduce("Figure 4.10: density through a front in an ideal gas", false, options, context);
}

} // namespace mesobridge::workflows
