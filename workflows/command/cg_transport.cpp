#include "workflows/command/options.hpp"
#include "workflows/report/report.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/star/diffusion_output.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

struct CgTransportOptions {
  std::filesystem::path input;
  cg::DiffusionSettings settings;
};

Result transport(CgTransportOptions const& options, Context const& context) {
  auto data = read_blobs(options.input);
  auto const head = data.head;
  require(head.rho > 0, "blobs", head.kind,
          "must be those of a melt or a trajectory: isolated molecules do not diffuse");
  refuse_walls(head, options.input, "diffusion");
  require(head.time_unit != "steps", "times of the blobs", "steps",
          "must be times, or D has no unit: give `cg blobs` the time step, --dt");
  auto const found = cg::diffusion(series_of(std::move(data)), options.settings);
  auto const folder = options.input.parent_path();
  auto const directory = context.output_directory(folder.empty() ? "." : folder);
  Provenance const provenance{.command = context.command_line(),
                              .seed = context.options.seed.value_or(0),
                              .scene = "",
                              .inputs = {options.input}};
  Result result;
  result.json = diffusion_json(found);
  result.json["units"] = units_text(head);
  result.json["provenance"] = provenance_json(provenance);
  write_summary(directory / "transport.json", result.json);
  auto report = diffusion_report(found, head.name, units_text(head));
  report.provenance = provenance;
  auto const file = directory / "transport.html";
  write_text_file(file, report.html());
  result.text = diffusion_text(found) + file.string();
  return result;
}

void declare(CLI::App& app, CgTransportOptions& options) {
  auto& s = options.settings;
  add_blob_file(app, options.input);
  app.add_option("--longest", s.longest,
                 "Lag up to which molecules are followed (default: a tenth of the run)");
  app.add_option("--viscosity", s.viscosity, "Of the fluid: corrects D for the images of the periodic box");
  app.add_option("--groups", s.groups, "Of molecules, whose spread is the standard error (default 16)");
}

} // namespace

Command::Action cg_transport_command(CLI::App& app) {
  return with_options<CgTransportOptions>(app, declare, transport);
}

} // namespace mesobridge::workflows
