#pragma once
#include "md/error.hpp"
#include "md/mpi_world.hpp"
#include "workflows/ranks.hpp"
#include "workflows/summary.hpp"

/// What the samplings of melts and of isolated molecules share. A Job has its settings, whether it goes on
/// from a checkpoint, and the file of its summary.
namespace mesobridge::workflows {

/// On the ranks that run already: `run` says whether it came to its end; rank 0 then writes what `summary`
/// makes.
template <class Job, class Run, class Summary>
void sample_stars(Job const& job, Context const& context, Run const& run, Summary const& summary) {
  guard_ranks([&] {
    md::MpiWorld const world;
    bool const complete = run(world, job, context);
    if (!world.is_root())
      return;
    if (!complete)
      throw Interrupted(
          fmt::format("interrupted; --resume goes on from '{}'", job.settings.restart_file().string()));
    write_summary(job.summary(), summary(job));
  });
}

/// Words of a call of this program.
struct CallWords {
  std::vector<std::string> words;

  template <class Value>
  void add(char const* option, Value const& value) {
    words.emplace_back(option);
    words.push_back(fmt::format("{}", value));
  }
};

/// The words that call `command` for the job and print no result, but for the options that it alone has.
template <class Job>
CallWords words_of_stars(char const* command, Job const& job) {
  auto const& s = job.settings;
  CallWords call{{"md", command, "--started-by-ourselves"}};
  call.add("--star", s.star.name());
  call.add("--molecules", s.molecules);
  call.add("--dt", s.dt);
  call.add("--equilibration-steps", s.equilibration_steps);
  call.add("--sampling-steps", s.sampling_steps);
  call.add("--sample-every", s.sample_every);
  call.add("--checkpoint-every", s.checkpoint_every);
  call.add("--seed", s.seed);
  call.add("-o", s.directory.string());
  if (job.resume)
    call.words.emplace_back("--resume");
  return call;
}

} // namespace mesobridge::workflows
