#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/metal/metal_options.hpp"
#include "workflows/metal/metal_sampler.hpp"
#include "workflows/metal/metal_table.hpp"
#include "workflows/ranks.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

struct MdMetalGridOptions {
  MetalOptions metal;
  std::vector<double> rho, T;
};

/// Densities from a crystal stretched by a hundredth to one compressed by a quarter; temperatures to several
/// times the melting point of most metals.
std::vector<md::MetalState> states_of(MdMetalGridOptions const& options, md::MetalSettings const& settings) {
  auto rho = options.rho, T = options.T;
  if (rho.empty())
    for (double part : {0.97, 1.0, 1.05, 1.12, 1.2})
      rho.push_back(part * md::stated_density(settings.potential));
  if (T.empty())
    T = {300, 700, 1200};
  std::vector<md::MetalState> states;
  for (double density : rho)
    for (double temperature : T)
      states.push_back({.rho = density, .T = temperature});
  for (auto const& state : states)
    md::check(state, settings);
  return states;
}

/// On the ranks that run already.
void sample(MetalJob const& job, std::span<md::MetalState const> states, Context const& context) {
  guard_ranks([&] {
    md::MpiWorld const world;
    if (!world.is_root())
      return MetalSampler::serve(world, job);
    MetalSampler sampler(world, job, context);
    sampler.sample(states, "states");
    sampler.close();
  });
}

/// Rereads what was sampled and writes the table.
Result table(MetalJob const& job, Context const& context) {
  auto const directory = job.runs.parent_path();
  auto const description = job.settings.description();
  auto const points = read_metal_points(job.runs, job.settings).points;
  Provenance const provenance{.command = context.command_line(),
                              .seed = job.settings.seed,
                              .scene = "",
                              .inputs = {job.settings.potential.file, job.runs}};
  auto const h5 = directory / "metal-grid.h5", csv = directory / "metal-grid.csv";
  write_metal_grid(h5, points, description, provenance);
  write_text_file(csv, metal_grid_csv(points));
  Result result;
  auto const warnings = warnings_on(points, job.settings);
  for (auto const& warning : warnings)
    context.log->warn("{}", warning);
  result.json = {{"file", h5.string()},     {"csv", csv.string()},  {"runs", job.runs.string()},
                 {"settings", description}, {"warnings", warnings}, {"states", metal_grid_json(points)}};
  result.text = fmt::format("{}\n{}{}", description, metal_grid_text(points), csv.string());
  write_summary(directory / "metal-grid.json", result.json);
  return result;
}

Result metal_grid(MdMetalGridOptions const& options, Context const& context) {
  MetalJob job{.settings = settings_of(options.metal, context), .runs = {}, .resume = options.metal.resume};
  auto const states = states_of(options, job.settings); // before any rank starts: bad input is told once
  auto const directory = context.output_directory("out/metal-grid");
  job.runs = directory / "metal-runs.h5";
  job.settings.log_file = directory / "lammps.log";
  keep_earlier_results(options.metal, job, directory, "metal-grid", context);
  if (!work_and_tell(context, options.metal.started_by_ourselves, [&] { sample(job, states, context); }))
    return told_elsewhere();
  return table(job, context);
}

void declare(CLI::App& app, MdMetalGridOptions& options) {
  add_options(app, options.metal);
  add_list(app, "--rho", options.rho, "Densities [kg/m^3] (default: 0.97 ... 1.2 times the crystal's)");
  add_list(app, "--T", options.T, "Temperatures [K] (default: 300, 700, 1200)");
}

} // namespace

extern Declaration const md_metal_grid_command = with_options<MdMetalGridOptions, declare, metal_grid>;

} // namespace mesobridge::workflows
