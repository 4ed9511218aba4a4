#include "workflows/shock_study/shock_tables.hpp"
#include "workflows/report/check.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include "workflows/shock_study/shock_quantities.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

cg::Estimate in(cg::Estimate const& e, double unit) {
  return {e.mean * unit, e.se * unit, e.n_eff};
}

} // namespace

std::vector<ShockQuantity> const& shock_quantities() {
  static std::vector<ShockQuantity> const list{{"v_S", "m/s", "v_S_m_s", 1, "v_S_m_s", 1, &ShockRow::v_S,
                                                [](auto const& s) { return s.v_S; }, &ShockErrors::v_S},
                                               {"rho", "kg/m^3", "rho_kg_m3", 1, "rho_kg_m3", 1,
                                                &ShockRow::rho, [](auto const& s) { return s.behind.rho; },
                                                &ShockErrors::rho},
                                               {"P", "GPa", "P_Pa", 1e-9, "P_GPa", 1e9, &ShockRow::P,
                                                [](auto const& s) { return s.behind.P; }, &ShockErrors::P},
                                               {"T", "K", "T_K", 1, "T_K", 1, &ShockRow::T,
                                                [](auto const& s) { return s.behind.T; }, &ShockErrors::T}};
  return list;
}

cg::Estimate judged(ShockRow const& row, ShockQuantity const& quantity) {
  return quantity.name == "rho" ? row.mass_per_volume : row.*quantity.of_row;
}

std::string digits_of(ShockQuantity const& quantity, double si) {
  return number_text(si * quantity.factor, 5);
}

ShockData shock_data_of(PistonData const& data) {
  return {data.scale, data.frames, data.molecules.empty() ? data.frames : data.molecules};
}

ShockRow md_row(PistonData const& data, ShockOfRun const& shock) {
  auto const& m = shock.measured;
  ShockRow row{.model = "MD",
               .K = 1,
               .spacing = data.scale.spacing,
               .particles = data.atoms,
               .v_S = m.v_S,
               .rho = m.rho,
               .mass_per_volume = shock.mass_per_volume,
               .P = m.P,
               .T = m.T,
               .T_kin = shock.T_kin,
               .depth = shock.depth};
  for (auto const& rho : shock.rho)
    row.profile.push_back(rho.mean), row.profile_se.push_back(rho.se);
  return row;
}

Json shock_json(fitting::Shock const& shock) {
  Json json;
  for (auto const& q : shock_quantities())
    json[q.key] = q.of_shock(shock);
  return json;
}

Json row_json(ShockRow const& row, PublishedTable const& printed, std::string const& printed_row) {
  Json json{{"model", row.model}, {"K", row.K}, {"particles", row.particles}};
  if (row.eta > 0)
    json["eta_Pa_s"] = row.eta;
  if (row.dt_reduced > 0)
    json["dt_reduced"] = row.dt_reduced;
  if (row.failed()) {
    json["failure"] = row.failure;
    return json;
  }
  if (row.Re_l)
    json["Re_l"] = *row.Re_l;
  for (auto const& q : shock_quantities())
    put(json, q.key, row.*q.of_row);
  put(json, "mass_per_volume_kg_m3", row.mass_per_volume);
  put(json, "T_kin_K", row.T_kin);
  if (!printed_row.empty())
    for (auto const& q : shock_quantities())
      json["printed_" + q.key] = printed.value(printed_row, q.printed) * q.printed_factor;
  return json;
}

Table shock_table(std::vector<ShownRow> const& rows, std::vector<NamedShock> const& exact,
                  PublishedTable const& printed, std::string const& caption) {
  Table table{.header = {"model", "K", "eta [Pa s]", "Re_l"}, .caption = caption};
  for (auto const& q : shock_quantities()) {
    table.header.push_back(fmt::format("{} [{}]", q.name, q.unit));
    if (q.name == "rho")
      table.header.push_back("mass/volume");
    table.header.push_back("printed");
  }
  table.header.push_back("T_kin [K]");
  for (auto const& [label, row, printed_row] : rows) {
    std::vector<std::string> cells{row.model, fmt::format("{:g}", row.K),
                                   row.eta > 0 ? fmt::format("{:g}", row.eta) : "",
                                   row.Re_l ? number_text(*row.Re_l, 3) : ""};
    for (auto const& q : shock_quantities()) {
      cells.push_back(row.failed() ? "fails" : with_error_text(in(row.*q.of_row, q.factor)));
      if (q.name == "rho")
        cells.push_back(row.failed() ? "" : with_error_text(row.mass_per_volume));
      cells.push_back(printed_row.empty() ? "" : number_text(printed.value(printed_row, q.printed), 5));
    }
    cells.push_back(row.failed() ? "" : with_error_text(row.T_kin));
    table.rows.push_back(cells);
  }
  for (std::size_t k = 0; k < exact.size(); ++k) {
    std::vector<std::string> cells{"R.-H., " + exact[k].name, "", "", ""};
    for (auto const& q : shock_quantities()) {
      cells.push_back(digits_of(q, q.of_shock(exact[k].shock)));
      if (q.name == "rho")
        cells.push_back("");
      cells.push_back(k == 0 ? number_text(printed.value("EoS", q.printed), 5) : "");
    }
    cells.emplace_back();
    table.rows.push_back(cells);
  }
  return table;
}

std::vector<VerdictLine> shock_verdicts(std::vector<ShockRow> const& rows, fitting::Shock const& exact,
                                        double bound, std::string const& of) {
  std::vector<VerdictLine> lines;
  for (auto const& q : shock_quantities()) {
    double const expected = q.of_shock(exact);
    // How many standard errors a row is beyond the bound.
    auto const excess = [&](ShockRow const& row) {
      auto const found = judged(row, q);
      return (std::abs(found.mean / expected - 1) - bound) * expected / found.se;
    };
    ShockRow const* worst = nullptr;
    for (auto const& row : rows)
      if (!row.failed() && (!worst || excess(row) > excess(*worst)))
        worst = &row;
    if (!worst)
      continue;
    auto const found = judged(*worst, q);
    lines.push_back(
        {.what = fmt::format("{} behind the front, {}", q.name == "rho" ? "mass per volume" : q.name, of),
         .found = fmt::format("{} {} at K = {:g}, eta = {:g} Pa s: {:+.2f} % ({:.2f} % se)",
                              with_error_text(in(found, q.factor)), q.unit, worst->K, worst->eta,
                              100 * (found.mean / expected - 1), 100 * found.se / expected),
         .expected = fmt::format("{} within {:g} %", digits_of(q, expected), 100 * bound),
         .verdict = excess(*worst) <= allowed_deviation(rows.size()) ? Verdict::passed : Verdict::failed,
         .deviation = fmt::format("{:.1f} se beyond; allowed {:.1f}", std::max(0.0, excess(*worst)),
                                  allowed_deviation(rows.size()))});
  }
  return lines;
}

Plot front_plot(std::string const& name, std::string const& title, std::vector<ShownRow> const& rows,
                std::optional<fitting::ShockProfile> const& navier_stokes, fitting::Shock const& exact,
                std::optional<double> spacing) {
  bool const reduced = spacing.has_value();
  Plot plot{.name = name,
            .title = title,
            .x = {.label = reduced ? "distance from the front [l of the particles]"
                                   : "distance from the front [nm]",
                  .min = -25,
                  .max = 10},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = "rho [kg/m^3]";
  panel.level_lines = {exact.ahead.rho, exact.behind.rho};
  auto const add = [&](std::string const& label, double unit, SeriesStyle style, std::size_t size,
                       auto const& at) {
    Series series{.label = label, .style = style};
    for (std::size_t k = 0; k < size; ++k)
      if (auto const [x, rho] = at(k); x / unit > *plot.x.min && x / unit < *plot.x.max)
        series.x.push_back(x / unit), series.y.push_back(rho);
    if (!series.x.empty())
      panel.series.push_back(std::move(series));
  };
  for (auto const& [label, row, printed] : rows)
    if (!row.failed())
      add(plain(label), reduced ? row.spacing : 1e-9, SeriesStyle::lines, row.depth.size(),
          [&row = row](std::size_t k) { return std::pair(row.depth[k], row.profile[k]); });
  if (navier_stokes)
    add("Navier-Stokes", reduced ? *spacing : 1e-9, SeriesStyle::dashes, navier_stokes->points.size(),
        [&](std::size_t k) {
          auto const& point = navier_stokes->points[k];
          return std::pair(point.x, point.state.rho);
        });
  return plot;
}

} // namespace mesobridge::workflows
