#pragma once
#include "md/error.hpp"
#include "md/mpi_world.hpp"
#include "workflows/call_words.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/ranks.hpp"
#include "workflows/star/blob_file.hpp"
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

/// What a file of blobs says of the stars of such settings.
template <class Settings>
BlobFileHead stars_head(std::string kind, Settings const& s, double mass, double rho, double T) {
  return {.kind = std::move(kind),
          .name = s.star.name(),
          .fingerprint = s.fingerprint(),
          .molecules = s.molecules,
          .atoms = s.star.atoms(),
          .mass = mass,
          .rho = rho,
          .T = T};
}

/// Shows how far a run is, and stops it for the user. Only rank 0 has a progress and is asked.
inline std::function<bool(std::int64_t, std::int64_t)> watched(std::optional<Progress>& progress) {
  return [&progress](std::int64_t done, std::int64_t all) {
    progress->update(double(done) / double(all));
    return !interrupt_requested();
  };
}

/// Closes the files of a run, which only rank 0 has; returns whether it is complete.
template <class Files>
bool closed(bool complete, std::optional<Files>& files, std::optional<Progress>& progress) {
  if (files)
    files->close();
  if (progress && complete)
    progress->finish();
  return complete;
}

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

/// The same of melts.
template <class Job>
CallWords words_of_melt(char const* command, Job const& job) {
  auto call = words_of_stars(command, job);
  auto const& s = job.settings;
  call.add("--rho", s.rho).add("--T", s.T).add("--friction", s.friction);
  return call.add("--squeeze-steps", s.squeeze_steps);
}

} // namespace mesobridge::workflows
