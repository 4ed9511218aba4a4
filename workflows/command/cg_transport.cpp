#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/report/report.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include "workflows/transport/beside.hpp"
#include "workflows/transport/diffusion_output.hpp"
#include "workflows/transport/measured_motion.hpp"
#include "workflows/transport/viscosity_output.hpp"
#include <CLI/CLI.hpp>
#include <cmath>

namespace mesobridge::workflows {
namespace {

struct CgTransportOptions {
  std::filesystem::path input;
  cg::DiffusionSettings settings;
  cg::ViscositySettings waves;
  std::optional<std::filesystem::path> beside;
};

/// The viscosity, or why there is none: a run may be long enough for diffusion alone.
struct FoundViscosity {
  std::optional<cg::Viscosity> value;
  std::string reason;
};

FoundViscosity viscosity_of(cg::BlobSeries const& series, cg::ViscositySettings const& settings) {
  try {
    return {cg::viscosity(series, settings), {}};
  } catch (InputError const& error) {
    return {{}, error.what()};
  }
}

bool is_cube(Box const& box) {
  return !box.tilted() &&
         std::max(std::abs(box.edge.x - box.edge.y), std::abs(box.edge.x - box.edge.z)) < 1e-6 * box.edge.x;
}

/// The diffusion, corrected by the viscosity that the user gives or, in a cube, the one that was measured.
cg::Diffusion diffusion_of(MeasuredMotion const& motion, cg::DiffusionSettings settings,
                           std::optional<cg::Viscosity> const& viscosity) {
  if (viscosity && settings.viscosity == 0 && is_cube(motion.series.boxes.front()))
    settings.viscosity = viscosity->eta.mean, settings.viscosity_se = viscosity->eta.se;
  auto found = cg::diffusion(motion.series, settings);
  found.temperature = cg::scaled(found.temperature, 1 / motion.boltzmann);
  return found;
}

Result numbers_of(MeasuredMotion const& motion, cg::Diffusion const& diffusion,
                  FoundViscosity const& viscosity) {
  Result result;
  result.json["name"] = motion.name, result.json["units"] = motion.units;
  result.json.update(diffusion_json(diffusion));
  if (viscosity.value)
    result.json.update(viscosity_json(*viscosity.value));
  else
    result.json["eta_missing"] = viscosity.reason;
  std::string const no_correction = "the box is no cube, for which alone the correction is";
  if (viscosity.value && !diffusion.D_infinite)
    result.json["D_infinite_missing"] = no_correction;
  result.text =
      diffusion_text(diffusion) +
      (viscosity.value ? viscosity_text(*viscosity.value) : "eta         none: " + viscosity.reason + "\n");
  if (viscosity.value && !diffusion.D_infinite)
    result.text += "D_infinite  none: " + no_correction + "\n";
  return result;
}

Result transport(CgTransportOptions const& options, Context const& context) {
  std::optional<TransportResult> other;
  if (options.beside)
    other = read_transport(*options.beside); // before any work
  cg::check(options.waves);
  auto const motion = read_motion(options.input, context);
  auto const viscosity = viscosity_of(motion.series, options.waves);
  auto const diffusion = diffusion_of(motion, options.settings, viscosity.value);
  auto result = numbers_of(motion, diffusion, viscosity);
  auto report = transport_report(diffusion, viscosity.value, motion.name, motion.units);
  report.provenance = {.command = context.command_line(),
                       .seed = context.options.seed.value_or(0),
                       .scene = "",
                       .inputs = {motion.file}};
  if (!viscosity.value)
    report.warnings.push_back("No viscosity: " + viscosity.reason);
  if (other) {
    report.provenance.inputs.emplace_back(transport_file(*options.beside));
    auto const ours = transport_result(result.json, "transport.json");
    result.json["beside"] = beside_json(ours, *other);
    result.text += beside_text(ours, *other);
    report.sections.insert(report.sections.begin(), beside_section(ours, *other));
  }
  result.json["provenance"] = provenance_json(report.provenance);
  auto const directory = context.output_directory(motion.folder);
  auto const page = directory / "transport.html";
  write_summary(directory / "transport.json", result.json);
  write_text_file(page, report.html());
  result.text += page.string();
  return result;
}

void declare(CLI::App& app, CgTransportOptions& options) {
  auto& s = options.settings;
  app.add_option("input", options.input,
                 "What `md star-melt` or `cg blobs` wrote, or the folder of a `run` with a trajectory")
      ->required()
      ->type_name("FILE.h5 or FOLDER");
  app.add_option("--longest", s.longest,
                 "Lag up to which molecules are followed (default: a tenth of the run)");
  app.add_option("--viscosity", s.viscosity,
                 "Of the fluid, with which D is corrected for the images of the periodic box (default: the "
                 "one measured)");
  app.add_option("--groups", s.groups, "Of molecules, whose spread is the standard error (default 16)");
  app.add_option("--waves", options.waves.reach,
                 "Longest wave vectors for the viscosity, in shortest ones (default 2)");
  app.add_option("--blocks", options.waves.blocks,
                 "Of the run, whose spread is the viscosity's standard error (default 8 to 16)");
  app.add_option("--beside", options.beside,
                 "transport.json of another fluid, or its folder, to draw and compare with")
      ->type_name("FILE.json");
}

} // namespace

extern Declaration const cg_transport_command = with_options<CgTransportOptions, declare, transport>;

} // namespace mesobridge::workflows
