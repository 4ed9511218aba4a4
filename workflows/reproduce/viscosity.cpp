#include "sdpd/method/mean_field_viscosity.hpp"
#include "sdpd/setup/viscosity_wave.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/viscosity_study.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

/// A run and what it found; a run that could not go on has no viscosity but says why.
struct Row {
  ViscosityCase of;
  sdpd::MeanFieldViscosity mean_field;
  std::optional<sdpd::MeasuredViscosity> found;
  std::string failure;

  bool is_sdpd() const { return of.name == "sdpd"; }
  /// The viscosity that the particles are given; nothing where that is a friction coefficient.
  std::optional<double> asked() const {
    return is_sdpd() ? std::optional(mean_field.dissipative) : std::nullopt;
  }
};

/// Reduced. Many relaxation times of the flow, and more for DPD and DPDE, whose steps are cheap. SDPD with
/// little friction flows as a more viscous fluid, so that less than the 25 of Eq. (S55) will do.
double time_of(ViscosityCase const& of, md::Preset preset) {
  double const relaxation = sdpd::relaxation_time(of.settings), longer = preset == md::Preset::paper ? 10 : 1;
  if (of.name != "sdpd")
    return (preset == md::Preset::quick ? 10 : 60 * longer) * relaxation;
  return longer * std::clamp(25 * relaxation, 60.0, 300.0);
}

/// A quick table has the viscous fluids with 65 neighbours alone: short runs would only show the start of a
/// flow.
std::vector<ViscosityCase> cases_of(ReproduceOptions const& options) {
  auto cases = viscosity_cases(options.seed);
  if (options.preset == md::Preset::quick)
    std::erase_if(cases, [](ViscosityCase const& of) {
      return of.name == "sdpd" &&
             (of.neighbours != 65 || sdpd::mean_field_viscosity(of.settings).dissipative < 1e-3);
    });
  return cases;
}

Row measure(ViscosityCase const& of, md::Preset preset) {
  Row row{of, sdpd::mean_field_viscosity(of.settings), std::nullopt, ""};
  try {
    row.found =
        sdpd::measure_viscosity(of.settings, time_of(of, preset), [] { return !interrupt_requested(); });
  } catch (PhysicsError const& error) {
    row.failure = error.what();
  }
  return row;
}

Json json_of(Row const& row) {
  std::string const unit = row.is_sdpd() ? "_Pa_s" : "";
  Json json{{"method", row.of.name}, {"neighbours", row.of.neighbours}};
  if (row.is_sdpd())
    json["K"] = row.of.K, json["asked" + unit] = *row.asked();
  json["mean_field" + unit] = row.mean_field.sum();
  if (!row.found) {
    json["failure"] = row.failure;
    return json;
  }
  put(json, "viscosity" + unit, row.found->viscosity);
  put(json, "T_kin_over_T", row.found->T_kin);
  json["amplitude_over_thermal_velocity"] = row.found->amplitude;
  return json;
}

std::string csv_of(std::vector<Row> const& rows) {
  std::string text =
      "method,K,neighbours,unit,asked,mean_field,viscosity,viscosity_se,T_kin_over_T,amplitude\n";
  for (auto const& row : rows)
    if (row.found)
      text += fmt::format("{},{},{:.4g},{},{},{:.6g},{:.6g},{:.3g},{:.5g},{:.3g}\n", row.of.name,
                          row.is_sdpd() ? fmt::format("{:g}", row.of.K) : "", row.of.neighbours,
                          row.is_sdpd() ? "Pa s" : "reduced",
                          row.asked() ? fmt::format("{:g}", *row.asked()) : "", row.mean_field.sum(),
                          row.found->viscosity.mean, row.found->viscosity.se, row.found->T_kin.mean,
                          row.found->amplitude);
  return text;
}

Table table_of(std::vector<Row> const& rows) {
  Table table{.header = {"method", "K", "neighbours", "asked", "mean field", "measured", "measured / asked"},
              .caption = "SDPD of argon at 1150 kg/m³ and 1000 K with Wendland's C4 kernel [Pa s]; DPD and "
                         "DPDE: a = 25, γ = 4.5, "
                         "ρ = 3, k_B T = 1. Mean field: friction and motion of a fluid without structure "
                         "(sdpd/README.md, Eq. (S55)). What is measured beyond it comes from the forces."};
  for (auto const& row : rows) {
    auto const relative = [&]() -> std::string {
      if (!row.found || !row.asked())
        return "";
      auto const& eta = row.found->viscosity;
      return with_error_text({eta.mean / *row.asked(), eta.se / *row.asked(), eta.n_eff});
    };
    table.rows.push_back({row.of.name, row.is_sdpd() ? number_text(row.of.K, 4) : "",
                          number_text(row.of.neighbours, 3), row.asked() ? number_text(*row.asked(), 3) : "",
                          number_text(row.mean_field.sum(), 4),
                          row.found ? with_error_text(row.found->viscosity) : row.failure, relative()});
  }
  return table;
}

/// Over K, one curve for each number of neighbours and viscosity asked for.
Plot plot_of(std::vector<Row> const& rows) {
  Plot plot{.name = "viscosity",
            .title = "Viscosity of SDPD over the one asked for",
            .x = {.label = "K", .logarithmic = true},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y = {.label = "measured / asked"};
  panel.level_lines = {1};
  for (auto const& row : rows) {
    if (!row.found || !row.asked())
      continue;
    auto const label = fmt::format("{:g} mPa s, {:g} neighbours", 1e3 * *row.asked(), row.of.neighbours);
    auto at = std::ranges::find(panel.series, label, &Series::label);
    if (at == panel.series.end())
      at = panel.series.insert(at, {.label = label, .x = {}, .y = {}, .y_error = {}});
    at->x.push_back(row.of.K), at->y.push_back(row.found->viscosity.mean / *row.asked()),
        at->y_error.push_back(row.found->viscosity.se / *row.asked());
  }
  return plot;
}

} // namespace

Reproduced reproduce_viscosity(ReproduceOptions const& options, Context const& context) {
  auto const cases = cases_of(options);
  auto progress = context.progress("Viscosity", static_cast<double>(cases.size()));
  std::vector<Row> rows;
  for (auto const& of : cases) {
    progress.update(static_cast<double>(rows.size()), of.name);
    rows.push_back(measure(of, options.preset));
    throw_if_interrupted();
  }
  progress.finish();
  Reproduced found;
  for (auto const& row : rows)
    found.summary["rows"].push_back(json_of(row));
  write_text_file(options.directory / "viscosity.csv", csv_of(rows));
  Section section{"Viscosities", {table_of(rows)}};
  if (auto const plot = plot_of(rows); !plot.panels[0].series.empty())
    section.content.emplace_back(Figure{{draw_svg(plot)}, "With standard errors."});
  section.content.emplace_back(Files{{{"viscosity.csv", "the table"}}});
  found.report = {
      .title = "The viscosity that particle fluids have",
      .lead = "Measured in periodic boxes by a wave of body force (sdpd/README.md, Eq. (S54)), beside "
              "the viscosity asked for.",
      .verdicts = {},
      .sections = {std::move(section)},
      .provenance = {}};
  return found;
}

} // namespace mesobridge::workflows
