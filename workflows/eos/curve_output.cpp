#include "workflows/eos/curve_output.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/report/report.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {

CurveFile curve_file(std::filesystem::path const& path) {
  auto const ending = path.extension();
  if (ending == ".csv")
    return CurveFile::csv;
  if (ending == ".svg")
    return CurveFile::svg;
  if (ending == ".html")
    return CurveFile::html;
  throw InputError(fmt::format("-o {}: the file must end in .csv, .svg or .html", path.string()));
}

void write_curve(Context const& context, Result& result, std::function<std::string()> const& csv,
                 std::function<Plot()> const& plot) {
  auto const& file = context.options.output;
  if (!file)
    return;
  interrupts_end_at_once(); // gnuplot may take its time with many points
  switch (curve_file(*file)) {
  case CurveFile::csv:
    write_text_file(*file, csv());
    break;
  case CurveFile::svg:
    write_text_file(*file, draw_svg(plot()));
    break;
  case CurveFile::html: {
    auto const drawing = plot();
    Report const report{.title = drawing.title,
                        .lead = "Computed from the equations of state named in the command below.",
                        .verdicts = {},
                        .sections = {{"Curves", {Figure{{draw_svg(drawing)}, ""}}}},
                        .provenance = {.command = context.command_line(), .scene = "", .inputs = {}}};
    write_text_file(*file, report.html());
    break;
  }
  }
  result.json["file"] = file->string();
  result.text += fmt::format("written to   {}\n", file->string());
}

void put_curve(Context const& context, Result& result, Columns const& columns, bool reduced,
               std::function<Plot()> const& plot) {
  result.json["curve"] = arrays(columns, reduced);
  write_curve(
      context, result, [&] { return csv_text(columns, reduced); }, plot);
}

double pressure_unit(bool reduced) {
  constexpr double GPa = 1e9;
  return reduced ? 1 : GPa;
}

std::string pressure_label(bool reduced) {
  return reduced ? "P*" : "P [GPa]";
}

std::string density_label(bool reduced) {
  return reduced ? "rho*" : "rho [kg/m^3]";
}

Series pressure_series(std::string const& label, std::vector<fitting::EosState> const& states, bool reduced) {
  Series series{.label = plain(label), .style = SeriesStyle::lines};
  for (auto const& state : states) {
    series.x.push_back(state.rho);
    series.y.push_back(state.P / pressure_unit(reduced));
  }
  return series;
}

std::vector<fitting::EosState> states_behind(std::vector<fitting::Shock> const& shocks) {
  std::vector<fitting::EosState> states;
  for (auto const& shock : shocks)
    states.push_back(shock.behind);
  return states;
}

} // namespace mesobridge::workflows
