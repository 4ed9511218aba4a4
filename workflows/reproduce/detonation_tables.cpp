#include "workflows/detonation_study/detonation_runs.hpp"
#include "workflows/eos/detonation_view.hpp"
#include "workflows/report/check.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/published.hpp"
#include <algorithm>

// Steady detonations of nitromethane: tables 6.4 and 6.5 of the thesis, with figures 6.11, 6.12 and 6.14.

namespace mesobridge::workflows {
namespace {

constexpr double Z_usual = 1e15, eta_printed = 2e-3, goal = 0.01;
constexpr double nm = 1e-9, GPa = 1e9;

std::array<std::int64_t, 3> lattice_of(md::Preset preset, double length = 1) {
  auto const scaled = [&](double n) { return static_cast<std::int64_t>(std::llround(n * length)); };
  if (preset == md::Preset::quick)
    return {7, 7, scaled(260)};
  return {12, 12, scaled(594)}; // the thesis's
}

DetonationCase case_of(double K, double Z, double eta, ReproduceOptions const& options) {
  return {.name = fmt::format("steady-K{:g}-Z{:g}-eta{:g}", K, Z, eta),
          .K = K,
          .Z = Z,
          .eta = eta,
          .lattice = lattice_of(options.preset, std::max(1.0, Z_usual / Z)),
          .seed = options.seed};
}

std::string label_of(DetonationRow const& row) {
  return fmt::format("K = {:g}, Z = {:g}/s, {:g} Pa s", row.K, row.Z, row.eta);
}

Table table_of(std::vector<DetonationRow> const& rows,
               std::function<std::pair<std::string, std::string>(DetonationRow const&)> const& printed) {
  Table table{
      .header = {"K", "Z [1/s]", "eta [Pa s]", "Re_l", "D [m/s]", "Chapman-Jouguet", "printed", "change of D",
                 "zone [nm]", "ZND", "printed", "zone [l]"},
      .caption =
          "D: velocity of the front, from six blocks of frames; change of D: from the first half of these "
          "frames to "
          "the second. Zone: 0.02 <= mean progress <= 0.98. Re_l = rho_0 D l/(4 eta/3): above 2 the front "
          "rings, which "
          "makes it fast. The last column says how many mean distances between particles the zone is long."};
  for (auto const& row : rows) {
    auto const [D, zone] = printed(row);
    double const Re = 1104 * row.D_theory * row.spacing / (4 * row.eta / 3);
    std::vector<std::string> cells{fmt::format("{:g}", row.K), fmt::format("{:g}", row.Z),
                                   fmt::format("{:g}", row.eta), number_text(Re, 2)};
    auto const in_nm = [](cg::Estimate const& e) { return cg::Estimate{e.mean / nm, e.se / nm, e.n_eff}; };
    if (row.failed())
      cells.insert(cells.end(), {"fails: " + row.failure, number_text(row.D_theory, 5), D, "", "",
                                 number_text(row.zone_theory / nm, 4), zone, ""});
    else
      cells.insert(cells.end(),
                   {with_error_text(row.D), number_text(row.D_theory, 5), D, with_error_text(row.change_of_D),
                    with_error_text(in_nm(row.zone)), number_text(row.zone_theory / nm, 4), zone,
                    number_text(row.zone.mean / row.spacing, 2)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Whether D is within 1 % of Chapman and Jouguet's, a line each.
std::vector<VerdictLine> verdicts_of(std::vector<DetonationRow> const& rows) {
  std::vector<VerdictLine> lines;
  for (auto const& row : rows) {
    auto const what = "velocity of the detonation, " + label_of(row);
    auto const expected = fmt::format("{} m/s within {:g} %", number_text(row.D_theory, 5), 100 * goal);
    if (row.failed()) {
      lines.push_back({what, row.failure, expected, Verdict::failed});
      continue;
    }
    double const off = row.D.mean / row.D_theory - 1;
    double const excess = (std::abs(off) - goal) * row.D_theory / row.D.se;
    lines.push_back({.what = what,
                     .found = fmt::format("{} m/s: {:+.2f} %", with_error_text(row.D), 100 * off),
                     .expected = expected,
                     .verdict = excess <= allowed_deviation(rows.size()) ? Verdict::passed : Verdict::failed,
                     .deviation = fmt::format("{:.1f} se beyond; allowed {:.1f}", std::max(0.0, excess),
                                              allowed_deviation(rows.size()))});
  }
  return lines;
}

Series series_of(std::string label, std::vector<double> x, double x_unit, std::vector<double> y,
                 double y_unit) {
  for (double& value : x)
    value /= x_unit;
  for (double& value : y)
    value /= y_unit;
  return {.label = std::move(label),
          .x = std::move(x),
          .y = std::move(y),
          .y_error = {},
          .style = SeriesStyle::lines};
}

/// Pressure and progress in the frame of the front; distances times Z/1e15, which makes zones equal.
Figure profiles_figure(std::vector<DetonationRow> const& rows, std::string const& caption) {
  Plot plot{.name = "profiles",
            .title = "In the frame of the front",
            .x = {.label = "distance from the front, times Z/1e15 [nm]", .min = -60, .max = 15},
            .panels = {Panel{}, Panel{.series = {}, .y = {}, .legend = Legend::none}}};
  plot.panels[0].y.label = "P [GPa]", plot.panels[1].y.label = "progress";
  for (auto const& row : rows)
    if (!row.failed()) {
      double const unit = nm * Z_usual / row.Z;
      plot.panels[0].series.push_back(series_of(label_of(row), row.depth, unit, row.P, GPa));
      plot.panels[1].series.push_back(series_of("", row.depth, unit, row.progress, 1));
    }
  return {{draw_svg(plot)}, caption};
}

Figure volume_figure(std::vector<DetonationRow> const& rows) {
  std::vector<SliceStates> slices;
  for (auto const& row : rows)
    if (row.K == 100 && row.Z == Z_usual && row.eta == eta_printed && !row.failed())
      slices.push_back({.label = label_of(row), .rho = row.slice_rho, .P = row.slice_P});
  auto const view = view_of(nitromethane_theory().fluid, "nitromethane", "nitromethane-products");
  return {{draw_svg(detonation_plot(view, 24 * GPa, 120, slices))},
          "Figure 6.12: the slices of the runs at their last instant, from the beginning of the wave to its "
          "front."};
}

Reproduced found_by(std::string const& title, std::string const& lead, std::vector<DetonationRow> const& rows,
                    PublishedTable const& printed,
                    std::function<std::pair<std::string, std::string>(DetonationRow const&)> const& of_row,
                    std::string const& profiles_caption) {
  auto found =
      reproduced(title, lead, rows, {"Detonations", {table_of(rows, of_row), Paragraph{printed.source}}});
  auto& report = found.report;
  report.verdicts = verdicts_of(rows);
  if (std::ranges::any_of(rows, [](auto const& row) { return !row.failed(); }))
    report.sections.push_back({"Profiles", {profiles_figure(rows, profiles_caption), volume_figure(rows)}});
  return found;
}

std::string const lead =
    "Nitromethane of 1104 kg/m^3 and 300 K between two mirrors; a layer of 24 mean distances between "
    "particles at the lower end begins as the products of Chapman and Jouguet, in motion. (The thesis's "
    "layer of 1869 kg/m^3 and 2330 K, at rest, did not set it off here: it burnt, and its shock died "
    "away.) The velocity of the detonation, beside that of Chapman and Jouguet by the same equations of "
    "state, and the length of its reaction zone beside that of Zel'dovich, von Neumann and Doering with "
    "the same kinetics. The quick preset's boxes are 260 mean distances long (the thesis's 594): the "
    "rarefaction follows the zone so closely that a broad front has not yet come to its velocity.";

} // namespace

Reproduced reproduce_table_6_4(ReproduceOptions const& options, Context const& context) {
  std::vector<DetonationCase> cases;
  for (double const eta : {eta_printed, 1e-2})
    for (double const K : {10, 100, 1000})
      cases.push_back(case_of(K, Z_usual, eta, options));
  auto const printed = published("thesis-table-6.4.csv");
  auto const rows = run_detonations("Table 6.4", cases, options, context);
  return found_by(
      "Table 6.4: the velocity of a detonation over the particle size", lead, rows, printed,
      [&](DetonationRow const& row) {
        return std::pair(
            row.eta == eta_printed ? number_text(printed.value(fmt::format("{:g}", row.K), "D_m_s"), 5) : "",
            std::string());
      },
      "Figure 6.11: pressure and progress behind the front, means over the frames.");
}

Reproduced reproduce_table_6_5(ReproduceOptions const& options, Context const& context) {
  std::vector<DetonationCase> cases;
  for (double const Z : {5e14, 8e14, 1e15, 2e15, 4e15})
    cases.push_back(case_of(100, Z, eta_printed, options));
  auto const printed = published("thesis-table-6.5.csv");
  auto const rows = run_detonations("Table 6.5", cases, options, context);
  return found_by(
      "Table 6.5: the reaction zone over the prefactor of the rate", lead, rows, printed,
      [&](DetonationRow const& row) {
        auto const exponent = row.Z < 1e15 ? 14 : 15;
        auto const name = fmt::format("{:g}e{}", row.Z / std::pow(10, exponent), exponent);
        return std::pair(number_text(printed.value(name, "D_m_s"), 5),
                         number_text(printed.value(name, "zone_nm"), 4));
      },
      "Figure 6.14: pressure and progress behind the front; lengths are scaled so that zones that are "
      "as long as theory says lie on each other.");
}

} // namespace mesobridge::workflows
