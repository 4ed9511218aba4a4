#include "workflows/command/options.hpp"
#include "workflows/earlier_results.hpp"
#include "workflows/json_file.hpp"
#include "workflows/ranks.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/star/melt_summary.hpp"
#include "workflows/trajectory/unit_style.hpp"

namespace mesobridge::workflows {

namespace {

struct MdMoleculesOptions {
  md::MoleculeMeltSettings settings;
  std::vector<int> replicate;
  bool keep_start = false, resume = false, started_by_ourselves = false;
};

/// --replicate N or NX NY NZ.
std::array<int, 3> boxes_along(std::vector<int> const& replicate) {
  if (replicate.empty())
    return {1, 1, 1};
  require(replicate.size() == 1 || replicate.size() == 3, "--replicate", replicate.size(),
          "must be one number, or three for x, y and z");
  return {replicate.front(), replicate[replicate.size() / 2], replicate.back()};
}

Result molecules(MdMoleculesOptions const& options, Context const& context) {
  MoleculesJob job{.settings = options.settings, .resume = options.resume};
  auto& s = job.settings;
  s.replicate = boxes_along(options.replicate);
  s.minimise = !options.keep_start;
  s.seed = context.options.seed.value_or(s.seed);
  unit_style(md::MoleculeMelt(s).system().units); // before any rank starts: bad input is told once
  s.directory = context.output_directory("out/molecules");
  if (!job.resume)
    keep_earlier_results(
        context, options.started_by_ourselves, s.directory,
        {job.blobs(), job.summary(), s.restart_file(), s.log_file(), s.directory / "centres.h5"});
  if (!work_and_tell(context, options.started_by_ourselves, [&] { sample_molecules(job, context); }))
    return told_elsewhere();
  Result result;
  result.json = read_json(job.summary());
  result.text = molecules_text(result.json);
  return result;
}

void declare(CLI::App& app, MdMoleculesOptions& options) {
  auto& s = options.settings;
  add_molecule_files(app, s.data, s.forces, s.styles);
  app.add_option("--replicate", options.replicate, "So many boxes along each edge: one number, or three")
      ->expected(1, 3);
  app.add_option("--rho", s.rho, "Atoms per unit of volume (default: the data file's)");
  app.add_option("--T", s.T, "Temperature of the thermostat (default: 1 in lj, else 300)");
  app.add_option("--friction", s.friction, "Friction of the thermostat (default: 1/(1000 time steps))");
  app.add_option("--dt", s.dt, "Time step (default: 0.002 in lj, 1 in real, 0.001 in metal)");
  app.add_flag("--no-minimise", options.keep_start, "Begin with the atoms where the data file has them");
  app.add_option("--squeeze-steps", s.squeeze_steps, "Steps of each change of the density");
  app.add_option("--equilibration-steps", s.equilibration_steps, "Steps at the final density");
  app.add_option("--sampling-steps", s.sampling_steps, "Steps at constant energy");
  app.add_option("--sample-every", s.sample_every, "Steps between frames (default 100)");
  add_restarts(app, s.checkpoint_every, options.resume, options.started_by_ourselves);
}

} // namespace

extern Declaration const md_molecules_command = with_options<MdMoleculesOptions, declare, molecules>;

} // namespace mesobridge::workflows
