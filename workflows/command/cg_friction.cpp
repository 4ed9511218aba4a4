#include "workflows/coarse/friction_output.hpp"
#include "workflows/command/options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct CgFrictionOptions {
  std::filesystem::path input;
  cg::FrictionSettings settings;
};

cg::PairFriction friction_of_file(CgFrictionOptions const& options, HeldData const& data,
                                  Context const& context) {
  auto settings = options.settings;
  settings.interval = interval_of(data);
  auto const configurations = configurations_of(data);
  auto progress = context.progress("Friction", 1);
  auto const found = cg::pair_friction(configurations, settings, [&](std::size_t done) {
    progress.update(double(done) / double(configurations.size()));
  });
  progress.finish();
  return found;
}

Result friction(CgFrictionOptions const& options, Context const& context) {
  auto const data = read_held(options.input);
  auto const found = friction_of_file(options, data, context);
  auto const folder = options.input.parent_path();
  auto const directory = context.output_directory(folder.empty() ? "." : folder);
  Provenance const provenance{.command = context.command_line(),
                              .seed = context.options.seed.value_or(0),
                              .scene = "",
                              .inputs = {options.input}};
  Result result;
  result.json = friction_json(found);
  result.json["units"] = units_text(data.head);
  result.json["provenance"] = provenance_json(provenance);
  write_text_file(directory / "friction.csv", friction_csv(found.table));
  write_summary(directory / "friction.json", result.json);
  auto report = friction_report(found, data.head.name, units_text(data.head));
  report.provenance = provenance;
  if (data.steps.size() % data.frames_of_each != 0)
    report.warnings.push_back("The last configuration is not complete, and is left out.");
  write_text_file(directory / "friction.html", report.html());
  if (auto const warning = plateau_warning(found); !warning.empty())
    context.log->warn(warning);
  result.text = friction_text(found) + (directory / "friction.csv").string();
  return result;
}

void declare(CLI::App& app, CgFrictionOptions& options) {
  auto& s = options.settings;
  app.add_option("file", options.input, "What `md held-blobs` wrote")->required()->type_name("FILE.h5");
  app.add_option("--plateau", s.plateau,
                 "Time at which the integrals are read (default: 8 memory times of the forces)");
  app.add_option(
      "--cutoff", s.cutoff,
      "Of the table (default: a bin beyond the frictions that differ from zero by 2 standard errors)");
  app.add_option("--bin-width", s.bin_width, "Of the distances (default 0.5)");
  app.add_option("--knots", s.knots, "Distance of the knots of the table's splines (default 1)");
}

} // namespace

Command::Action cg_friction_command(CLI::App& app) {
  return with_options<CgFrictionOptions>(app, declare, friction);
}

} // namespace mesobridge::workflows
