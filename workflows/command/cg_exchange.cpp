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

/// The conduction that makes the flows, with what friction takes from both of a pair (cg/README.md, Eq. (C41)).
std::vector<ConductionRow> conduction_of(cg::EnergyExchange const& found, CgExchangeOptions const& options, double mass,
                                         double kT) {
  std::optional<sdpd::TabulatedFriction> friction;
  if (options.friction) {
    auto columns = read_columns(*options.friction, {"r", "gamma_par"}, {"gamma_perp", "gamma_par_se", "gamma_perp_se"});
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

Result exchange(CgExchangeOptions const& options, Context const& context) {
  auto data = read_blobs(options.input);
  auto const head = data.head;
  require(head.rho > 0, "blobs", head.kind, "must be those of a melt or a trajectory: isolated molecules exchange nothing");
  refuse_walls(head, options.input, "exchange of energy");
  double const kT = kT_of(data);
  auto const found = cg::energy_exchange(series_of(std::move(data)), options.settings);
  auto const rows = conduction_of(found, options, head.mass, kT);
  auto const folder = options.input.parent_path();
  auto const directory = context.output_directory(folder.empty() ? "." : folder);
  std::vector<InputFile> inputs{options.input};
  if (options.friction)
    inputs.emplace_back(*options.friction);
  Provenance const provenance{.command = context.command_line(), .seed = context.options.seed.value_or(0), .scene = "", .inputs = inputs};
  Result result;
  result.json = exchange_json(found, rows);
  result.json["units"] = units_text(head);
  result.json["provenance"] = provenance_json(provenance);
  write_text_file(directory / "conduction.csv", conduction_csv(rows, options.settings.cutoff));
  write_summary(directory / "exchange.json", result.json);
  auto report = exchange_report(found, rows, options.settings, head.name, units_text(head));
  report.provenance = provenance;
  write_text_file(directory / "exchange.html", report.html());
  result.text = exchange_text(found) + (directory / "conduction.csv").string();
  return result;
}

void declare(CLI::App& app, CgExchangeOptions& options) {
  auto& s = options.settings;
  app.add_option("file", options.input, "What `md star-melt` or `cg blobs` wrote")->required()->type_name("FILE.h5");
  app.add_option("--friction", options.friction, "CSV with columns r,gamma_par,gamma_perp: what friction takes from both of a pair is added")
      ->type_name("FILE.csv");
  app.add_option("--longest", s.longest, "Lag up to which energies are followed (default 2)");
  app.add_option("--from", s.from, "Lag from which energy passes steadily (default 0.5)");
  app.add_option("--to", s.to, "Lag up to which it does (default 1.5)");
  app.add_option("--cutoff", s.cutoff, "Beyond which molecules are strangers (default 8)");
  app.add_option("--bin-width", s.width, "Of the distances (default 0.5)");
}

} // namespace

Command::Action cg_exchange_command(CLI::App& app) {
  return with_options<CgExchangeOptions>(app, declare, exchange);
}

} // namespace mesobridge::workflows
