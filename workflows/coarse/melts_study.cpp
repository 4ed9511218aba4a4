#include "workflows/coarse/melts_study.hpp"
#include "workflows/json_file.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

struct Shown {
  char const *key, *what;
};
constexpr Shown compared[] = {{"P", "pressure"},
                              {"T_kin", "temperature of the motion"},
                              {"T_int", "temperature of the internal energies"},
                              {"internal_energy", "internal energy"},
                              {"internal_energy_spread", "its standard deviation"},
                              {"diffusion", "diffusion, by displacements"},
                              {"D_velocity", "diffusion, by velocities"},
                              {"velocity_decay_time", "velocities to 1/e"},
                              {"eta", "shear viscosity"}};

/// What the particles have over what the molecules have, less 1, in %; none where one of both is missing.
/// `run` is a row of a chain, or one of its runs.
std::optional<cg::Estimate> percent_apart(Json const& row, Json const& run, std::string const& key) {
  auto const md = key + "_md", dpde = key + "_dpde";
  if (!row.contains(md) || !run.contains(dpde))
    return std::nullopt;
  double const molecules = row[md], particles = run[dpde], scale = 100 / std::abs(molecules);
  return cg::Estimate{scale * (particles - molecules),
                      scale * std::hypot(row.value(md + "_se", 0.0), run.value(dpde + "_se", 0.0))};
}

std::string cell(Json const& row, Json const& run, std::string const& key) {
  auto const apart = percent_apart(row, run, key);
  return apart ? with_error_text(*apart) : "";
}

std::vector<std::string> header(std::string const& first) {
  std::vector<std::string> names{first, "g(r)"};
  for (auto const& [key, what] : compared)
    names.emplace_back(what);
  return names;
}

std::vector<std::string> cells(std::string const& name, Json const& row, Json const& run) {
  std::vector<std::string> cells{name, fmt::format("{:.2g}", 100 * run.value("g_deviation", 0.0))};
  for (auto const& [key, what] : compared)
    cells.push_back(cell(row, run, key));
  return cells;
}

std::string name_of(Json const& row) {
  return fmt::format("{}, ρ = {:g}", row.value("star", ""), row.value("rho", 0.0));
}

Table own_models(Json const& rows) {
  Table table{.header = header("melt"),
              .caption =
                  "Particles less molecules in % of the molecules' value, with one standard error; of g "
                  "the root mean square. Each model was found in its own melt."};
  for (auto const& row : rows)
    table.rows.push_back(cells(name_of(row), row, row));
  return table;
}

Table other_models(Json const& rows) {
  Table table{.header = header("melt, model"),
              .caption = "The same with the model that was found in another melt."};
  for (auto const& row : rows)
    for (auto const& run : row.at("runs"))
      if (auto const model = run.value("model", ""); !model.empty()) {
        auto const folder = std::filesystem::path(model).parent_path();
        auto const of = folder.filename() == "model" ? folder.parent_path().filename().string() : model;
        table.rows.push_back(cells(name_of(row) + ", model of " + of, row, run));
      }
  return table;
}

Table costs(Json const& rows) {
  Table table{.header = {"melt", "γ of a molecule", "ms a molecule and time", "time step",
                         "ms a particle and time", "faster"},
              .caption = "Processor time on this machine."};
  for (auto const& row : rows)
    for (auto const& run : row.at("runs"))
      if (run.value("model", "").empty())
        table.rows.push_back(
            {name_of(row), with_error_text({row.value("gamma_self", 0.0), row.value("gamma_self_se", 0.0)}),
             number_text(1e3 * row.value("seconds_per_molecule_and_time_md", 0.0), 3),
             number_text(run.value("dt", 0.0), 3),
             number_text(1e3 * run.value("seconds_per_molecule_and_time_dpde", 0.0), 3),
             number_text(run.value("speed_up", 0.0), 3)});
  return table;
}

/// Over the densities, a series for each star.
std::string figure_of(MeltsStudy const& study, Json const& rows, Shown const& of) {
  auto plot = one_panel(of.key, of.what, "ρ", "particles less molecules [%]", {0});
  for (auto const& star : study.stars) {
    Series series{.label = star, .style = SeriesStyle::points};
    for (auto const& row : rows)
      if (auto const apart = percent_apart(row, row, of.key); apart && row.value("star", "") == star) {
        series.x.push_back(row.value("rho", 0.0)), series.y.push_back(apart->mean);
        series.y_error.push_back(apart->se);
      }
    if (!series.x.empty())
      plot.panels[0].series.push_back(std::move(series));
  }
  return plot.panels[0].series.empty() ? std::string() : draw_svg(plot);
}

Figure over_densities(MeltsStudy const& study, Json const& rows) {
  Figure figure{{}, "What the particles are off by; nothing was adjusted to their runs."};
  for (auto const& of : compared)
    if (auto svg = figure_of(study, rows, of); !svg.empty())
      figure.svgs.push_back(std::move(svg));
  return figure;
}

} // namespace

std::string melt_folder(std::string const& star, double rho) {
  return fmt::format("{}-rho-{:g}", star, rho);
}

std::vector<Stage> study_stages(MeltsStudy const& study, std::filesystem::path const& directory) {
  std::vector<Stage> stages;
  for (auto const& star : study.stars)
    for (double const rho : study.densities) {
      auto const folder = directory / melt_folder(star, rho);
      Stage stage{fmt::format("{} stars at ρ = {:g}", star, rho),
                  {"workflow", "star-to-dpde", "--star", star, "--rho", fmt::format("{}", rho), "-o",
                   folder.string()},
                  folder / "summary.json"};
      stage.words.insert(stage.words.end(), study.words.begin(), study.words.end());
      if (study.transfer && rho != study.densities.front())
        stage.words.insert(stage.words.end(),
                           {"--other-model", (directory / melt_folder(star, study.densities.front()) /
                                              "model" / (star + "-melt.toml"))
                                                 .string()});
      stages.push_back(std::move(stage));
    }
  return stages;
}

Json study_summary(MeltsStudy const& study, std::filesystem::path const& directory) {
  Json summary{{"rows", Json::array()}};
  for (auto const& star : study.stars)
    for (double const rho : study.densities) {
      auto const file = directory / melt_folder(star, rho) / "summary.json";
      auto row = read_json(file);
      if (!row.contains("runs") || !row["runs"].is_array())
        throw InputError(fmt::format("'{}' does not hold the runs of a chain", file.string()));
      summary["rows"].push_back(std::move(row));
    }
  return summary;
}

Report study_report(MeltsStudy const& study, Json const& summary) {
  auto const& rows = summary.at("rows");
  Report report;
  report.title = "Melts of stars and the DPDE fluids made of them";
  report.lead =
      fmt::format("{} melts, each measured, coarsened and run by one command. Each has a report of its own.",
                  rows.size());
  Section all{"What is kept", {over_densities(study, rows), own_models(rows)}};
  if (auto table = other_models(rows); !table.rows.empty())
    all.content.emplace_back(std::move(table));
  Files files;
  for (auto const& row : rows)
    files.entries.push_back(
        {melt_folder(row.value("star", ""), row.value("rho", 0.0)) + "/report.html", name_of(row)});
  report.sections = {std::move(all), {"Cost", {costs(rows)}}, {"Each melt", {std::move(files)}}};
  return report;
}

} // namespace mesobridge::workflows
