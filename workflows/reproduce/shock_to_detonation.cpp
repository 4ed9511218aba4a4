#include "workflows/detonation_study/detonation_runs.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/sdpd/space_time.hpp"
#include <algorithm>

// The transition from a shock to a detonation: figures 6.7, 6.9, 6.10 and 6.13 of the thesis.

namespace mesobridge::workflows {
namespace {

constexpr double Z_usual = 1e15, nm = 1e-9, ps = 1e-12;

/// A start of the piston: its ramp, and what readers call it.
struct Start {
  std::string name;
  std::optional<double> ramp;
};
Start const at_once{"impulsive", 0}, ramped{"ramped", std::nullopt};

DetonationCase case_of(double K, double Z, Start const& start, ReproduceOptions const& options) {
  double const longer = std::max(1.0, Z_usual / Z) * (K < 50 ? 1.5 : 1);
  bool const quick = options.preset == md::Preset::quick;
  return {.name = fmt::format("piston-K{:g}-Z{:g}-{}", K, Z, start.name),
          .K = K,
          .Z = Z,
          .lattice = quick ? std::array<std::int64_t, 3>{7, 7, std::llround(320 * longer)}
                           : std::array<std::int64_t, 3>{12, 12, std::llround(594 * longer)},
          .seed = options.seed,
          .piston = true,
          .ramp = start.ramp};
}

std::string label_of(DetonationRow const& row) {
  return fmt::format("K = {:g}, Z = {:g} 1/s, {}", row.K, row.Z, row.ramp == 0 ? "impulsive" : "ramped");
}

Table table_of(std::vector<DetonationRow> const& rows) {
  Table table{
      .header = {"K", "Z [1/s]", "start", "D [m/s]", "Chapman-Jouguet", "t_D(z = 0) [ps]"},
      .caption =
          "t_D(z = 0): when the front of the detonation, drawn back on a straight line, would have left "
          "the place of the piston; the thesis prints 15.7 ps (K = 10) to 14.0 ps (K = 10000)."};
  for (auto const& row : rows) {
    std::vector<std::string> cells{fmt::format("{:g}", row.K), fmt::format("{:g}", row.Z),
                                   row.ramp == 0 ? "impulsive" : "ramped"};
    if (row.failed())
      cells.insert(cells.end(), {"none: see below", number_text(row.D_theory, 5), ""});
    else {
      auto const t = row.time_to_detonation();
      cells.insert(cells.end(), {with_error_text(row.D), number_text(row.D_theory, 5),
                                 with_error_text({t.mean / ps, t.se / ps, t.n_eff})});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The table, and why some runs have no line of a detonation in it.
Section transitions_of(std::vector<DetonationRow> const& rows) {
  Section section{"Transitions", {table_of(rows)}};
  for (auto const& row : rows)
    if (row.failed())
      section.content.push_back(Paragraph{label_of(row) + ": " + row.failure + "."});
  return section;
}

/// The ways of the fronts; times and places are multiplied with `scale` of the row.
Figure ways(std::vector<DetonationRow> const& rows, std::function<double(DetonationRow const&)> const& scale,
            std::string const& caption) {
  auto plot = one_panel("ways", "Position of the front", "time [ps]", "front [nm]");
  for (auto const& row : rows) {
    Series series{.label = label_of(row), .style = SeriesStyle::lines};
    for (std::size_t k = 0; k < row.times.size(); ++k)
      series.x.push_back(row.times[k] / ps * scale(row)), series.y.push_back(row.fronts[k] / nm * scale(row));
    if (!series.x.empty())
      plot.panels[0].series.push_back(std::move(series));
  }
  return {{draw_svg(plot)}, caption};
}

/// Space-time diagrams out of the files of the runs.
Figure pictures_of(std::vector<DetonationCase> const& cases, ReproduceOptions const& options,
                   std::vector<std::string> const& quantities, std::string const& caption) {
  Figure figure{{}, caption};
  for (auto const& one : cases) {
    auto const file = options.directory / "runs" / one.name / "run.h5";
    if (!std::filesystem::exists(file))
      continue;
    auto const scene = detonation_scene(one);
    auto const settings = settings_of(scene, 1);
    auto pictures =
        space_time_pictures(Store(file, Store::Mode::read), scene, {settings.units(), scene.units},
                            fmt::format("K = {:g}", one.K), quantities);
    std::ranges::move(pictures, std::back_inserter(figure.svgs));
  }
  return figure;
}

std::string const lead =
    "A piston at 1764 m/s drives a shock into nitromethane of 1104 kg/m^3 and 300 K, which becomes a "
    "detonation. Without walls the shocked fluid would need 189 ps before it explodes. A piston that "
    "starts at once overheats what stands before it, for ever, and there the detonation begins: the time "
    "to detonation measures the start. So both are shown: at once, as in the thesis, and over a ramp of 8"
    " l/v_S, which overheats little.";

} // namespace

Reproduced reproduce_figure_6_10(ReproduceOptions const& options, Context const& context) {
  std::vector<DetonationCase> cases;
  auto const sizes = options.preset == md::Preset::quick ? std::vector<double>{10, 100, 1000}
                                                         : std::vector<double>{10, 100, 1000, 10000};
  for (auto const& start : {at_once, ramped})
    for (double const K : sizes)
      cases.push_back(case_of(K, Z_usual, start, options));
  auto const rows = run_detonations("Shock to detonation", cases, options, context);
  auto found =
      reproduced("Figures 6.7, 6.9 and 6.10: from a shock to a detonation", lead, rows, transitions_of(rows));
  auto& sections = found.report.sections;
  sections.push_back(
      {"Figure 6.10",
       {ways(
           rows, [](auto const&) { return 1.0; },
           "The last crossing, from ahead, of half the velocity of Chapman and Jouguet's products.")}});
  std::vector<DetonationCase> impulsive(cases.begin(),
                                        cases.begin() + static_cast<std::ptrdiff_t>(sizes.size()));
  sections.push_back({"Figure 6.7", {pictures_of({impulsive[1]}, options, {}, "K = 100, impulsive start.")}});
  sections.push_back(
      {"Figure 6.9",
       {pictures_of(impulsive, options, {"T_int"}, "Temperatures over the size, impulsive start.")}});
  return found;
}

Reproduced reproduce_figure_6_13(ReproduceOptions const& options, Context const& context) {
  std::vector<DetonationCase> cases;
  for (double const Z : {5e14, 1e15, 2e15})
    cases.push_back(case_of(100, Z, at_once, options));
  auto const rows = run_detonations("Shock to detonation over Z", cases, options, context);
  auto found = reproduced("Figure 6.13: from a shock to a detonation, over the prefactor of the rate", lead,
                          rows, transitions_of(rows));
  found.report.sections.push_back(
      {"Figure 6.13",
       {ways(
           rows, [](auto const& row) { return row.Z / Z_usual; },
           "Times and places are multiplied with Z/1e15: without walls all lines would be one.")}});
  return found;
}

} // namespace mesobridge::workflows
