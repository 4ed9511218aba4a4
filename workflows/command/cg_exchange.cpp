#include "md/error.hpp"
#include "sdpd/friction/friction_shape.hpp"
#include "workflows/coarse/exchange_output.hpp"
#include "workflows/coarse/structure_of_blobs.hpp"
#include "workflows/command/options.hpp"
#include "workflows/sdpd/column_file.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {
namespace {

struct CgExchangeOptions {
  std::filesystem::path input;
  std::optional<std::filesystem::path> friction;
  cg::ExchangeSettings settings;
};

/// The conduction that makes the flows, with what friction takes from both of a pair (cg/README.md, Eq.
/// (C41)).
std::vector<ConductionRow> conduction_of(cg::EnergyExchange const& found, CgExchangeOptions const& options,
                                         double mass, double kT) {
  std::optional<sdpd::TabulatedFriction> friction;
  if (options.friction) {
    auto columns =
        read_columns(*options.friction, {"r", "gamma_par"}, {"gamma_perp", "gamma_par_se", "gamma_perp_se"});
    friction.emplace(columns["r"], columns["gamma_par"], columns["gamma_perp"]);
  }
  std::vector<ConductionRow> rows;
  for (auto const& bin : found.bins) {
    auto kappa = bin.flow;
    if (friction) {
      auto const [par, perp] = (*friction)(bin.r);
      kappa.mean += (par + 2 * perp) * kT * kT / (2 * mass);
    }
    rows.push_back({bin.r, kappa});
  }
  return rows;
}

cg::ConductionTable table_of(std::vector<ConductionRow> const& rows, double cutoff) {
  std::vector<double> r;
  std::vector<cg::Estimate> kappa;
  for (auto const& row : rows)
    r.push_back(row.r), kappa.push_back(row.kappa);
  return cg::conduction_table(r, kappa, cutoff);
}

Result exchange(CgExchangeOptions const& options, Context const& context) {
  auto data = read_blobs(options.input);
  auto const head = data.head;
  require(head.rho > 0, "blobs", head.kind,
          "must be those of a melt or a trajectory: isolated molecules exchange nothing");
  refuse_walls(head, options.input, "exchange of energy");
  double const kT = kT_of(data);
  auto const found = cg::energy_exchange(series_of(std::move(data)), options.settings);
  auto const rows = conduction_of(found, options, head.mass, kT);
  auto const table = table_of(rows, found.cutoff);
  auto const folder = options.input.parent_path();
  auto const directory = context.output_directory(folder.empty() ? "." : folder);
  std::vector<InputFile> inputs{options.input};
  if (options.friction)
    inputs.emplace_back(*options.friction);
  Provenance const provenance{.command = context.command_line(),
                              .seed = context.options.seed.value_or(0),
                              .scene = "",
                              .inputs = inputs};
  Result result;
  result.json = exchange_json(found, rows, table);
  result.json["units"] = units_text(head);
  result.json["provenance"] = provenance_json(provenance);
  write_text_file(directory / "conduction.csv", conduction_csv(table));
  write_summary(directory / "exchange.json", result.json);
  auto report = exchange_report(found, rows, table, head.name, units_text(head));
  report.provenance = provenance;
  write_text_file(directory / "exchange.html", report.html());
  result.text = exchange_text(found) + (directory / "conduction.csv").string();
  return result;
}

void declare(CLI::App& app, CgExchangeOptions& options) {
  auto& s = options.settings;
  app.add_option("file", options.input, "What `md star-melt` or `cg blobs` wrote")
      ->required()
      ->type_name("FILE.h5");
  app.add_option("--friction", options.friction,
                 "CSV with columns r,gamma_par,gamma_perp: what friction takes from both of a pair is added")
      ->type_name("FILE.csv");
  auto const add = [&](char const* name, double& value, char const* text) {
    app.add_option(name, value, text)->check(CLI::PositiveNumber)->capture_default_str();
  };
  add("--from", s.from, "First lag of the parabolas whose slopes are the flows (default: one frame)");
  add("--to", s.to, "Last lag (default: 0.4 of the time in which internal energies decay)");
  add("--longest", s.longest, "Lag up to which energies are followed (default: twice that time)");
  add("--cutoff", s.cutoff, "Beyond which molecules are strangers (default: two thirds of half the box)");
  app.add_option("--bin-width", s.width, "Of the distances (default 0.5)");
}

} // namespace

extern Declaration const cg_exchange_command = with_options<CgExchangeOptions, declare, exchange>;

} // namespace mesobridge::workflows
