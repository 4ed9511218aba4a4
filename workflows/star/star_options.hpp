#pragma once
#include "workflows/earlier_results.hpp"
#include "workflows/json_file.hpp"
#include "workflows/ranks.hpp"
#include "workflows/shared_options.hpp"

/// What the commands that sample stars share. A Job is as in star_sampling.hpp, Settings are those of its
/// run.
namespace mesobridge::workflows {

struct StarOptions {
  std::string star = "6-3";
  bool resume = false;
  bool started_by_ourselves = false;
};

/// Adds the options that all of them have; the help says what the settings hold.
template <class Settings>
void add_options(CLI::App& app, StarOptions& options, Settings& s, std::string const& equilibration,
                 std::string const& sampling) {
  app.add_option("--star", options.star, "ARMS-BEADS, up to 12-24 (default 6-3)")->type_name("N-N");
  app.add_option("--molecules", s.molecules, fmt::format("Number of stars (default {})", s.molecules));
  app.add_option("--dt", s.dt, fmt::format("Time step (default {})", s.dt));
  app.add_option("--equilibration-steps", s.equilibration_steps, equilibration);
  app.add_option("--sampling-steps", s.sampling_steps, sampling);
  app.add_option("--sample-every", s.sample_every,
                 fmt::format("Steps between frames (default {})", s.sample_every));
  add_restarts(app, s.checkpoint_every, options.resume, options.started_by_ourselves);
}

/// Adds those of melts.
template <class Settings>
void add_melt_options(CLI::App& app, Settings& s) {
  app.add_option("--rho", s.rho, "Beads per sigma^3 (default 0.3)");
  app.add_option("--T", s.T, "Temperature of the thermostat (default 1)");
  app.add_option("--friction", s.friction, "Friction of the thermostat (default 1)");
  app.add_option("--squeeze-steps", s.squeeze_steps, "Steps of each growth of the density");
}

/// Makes the run by `sample`, on as many ranks as the context asks for, and tells of it by the text of its
/// summary. What an earlier call left is kept, unless the run goes on from it.
template <class Job>
Result sampled(Job job, StarOptions const& options, std::string const& folder,
               std::vector<std::string> const& further_files, void (*sample)(Job const&, Context const&),
               std::string (*text)(Json const&), Context const& context) {
  auto& s = job.settings;
  s.star = md::star_of_name(options.star);
  s.seed = context.options.seed.value_or(s.seed);
  md::check(s); // before any rank starts: bad input is told once
  s.directory = context.output_directory(folder);
  job.resume = options.resume;
  std::vector<std::filesystem::path> files{job.blobs(), job.summary(), s.restart_file(), s.log_file()};
  for (auto const& name : further_files)
    files.push_back(s.directory / name);
  if (!job.resume)
    keep_earlier_results(context, options.started_by_ourselves, s.directory, files);
  sample(job, context);
  if (options.started_by_ourselves || !md::MpiWorld().is_root())
    return told_elsewhere();
  Result result;
  result.json = read_json(job.summary());
  result.text = text(result.json);
  return result;
}

} // namespace mesobridge::workflows
