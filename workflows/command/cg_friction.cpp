#include "md/error.hpp"
#include "workflows/coarse/friction_output.hpp"
#include "workflows/command/options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include "workflows/transport/beside.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct CgFrictionOptions {
  std::filesystem::path input;
  std::optional<std::filesystem::path> velocities;
  cg::FrictionSettings settings;
};

/// The time in which the velocities of free molecules fall to 1/e: what forces remember for longer is no
/// friction of particles without memory.
double velocity_decay(std::filesystem::path const& file) {
  auto const transport = read_transport(file);
  auto const found =
      std::ranges::find(transport.numbers, "velocity_decay_time", [](auto const& of) { return of.first; });
  require(found != transport.numbers.end(), "--velocities", file.string(),
          "holds no time in which velocities fall to 1/e: its frames were too far apart, or too few");
  return found->second.mean;
}

cg::PairFriction friction_of_file(CgFrictionOptions const& options, HeldData const& data,
                                  Context const& context) {
  auto settings = options.settings;
  if (options.velocities)
    settings.plateau = velocity_decay(*options.velocities);
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
  Provenance const provenance{
      .command = context.command_line(),
      .seed = context.options.seed.value_or(0),
      .scene = "",
      .inputs = options.velocities
                    ? std::vector<InputFile>{options.input, transport_file(*options.velocities)}
                    : std::vector<InputFile>{options.input}};
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
  auto* const plateau = app.add_option(
      "--plateau", s.plateau, "Time at which the integrals are read (default: 8 memory times of the forces)");
  app.add_option("--velocities", options.velocities,
                 "transport.json of the free melt, or its folder: the integrals are read when its velocities "
                 "have fallen to "
                 "1/e")
      ->type_name("FILE.json")
      ->excludes(plateau);
  app.add_option(
      "--cutoff", s.cutoff,
      "Of the table (default: a bin beyond the frictions that differ from zero by 2 standard errors)");
  app.add_option("--bin-width", s.bin_width, "Of the distances (default 0.5)");
  app.add_option("--knots", s.knots, "Distance of the knots of the table's splines (default 1)");
}

} // namespace

extern Declaration const cg_friction_command = with_options<CgFrictionOptions, declare, friction>;

} // namespace mesobridge::workflows
