#pragma once
#include "md/lammps_session.hpp"
#include "md/star_polymer.hpp"
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace mesobridge::md {

/// Writes a checkpoint of the session into a new file, lets the others put in safety what belongs to it, and
/// only then lets the new file take the old one's place. All ranks must call it.
void write_checkpoint(MpiWorld const& world, LammpsSession& lammps, std::filesystem::path const& file,
                      std::function<void()> const& before_it_counts);

/// Where a run's checkpoint is, and what sets a fresh session's styles before it is read.
struct Checkpoint {
  std::filesystem::path restart_file, log_file;
  std::function<void(LammpsSession&)> prepare;
};

/// The step that a run begins at: that of its checkpoint when it is resumed, or else 0, and an old checkpoint
/// is removed. All ranks must call it.
std::int64_t step_to_begin_at(MpiWorld const& world, Checkpoint const& checkpoint, bool resume);

/// A star as the fingerprints of runs name it: "6-3 star (k = 20, l = 1.147, 1.615, WCA)".
std::string fingerprint(StarPolymer const& star);

/// All steps of a run of these stretches.
template <class Stretch>
std::int64_t steps_of(std::vector<Stretch> const& stretches) {
  return stretches.back().first_step + stretches.back().steps;
}

/// The step that a run of these stretches begins at, one after the other. Throws InputError that ends in
/// `why` when none of them begins at the checkpoint.
template <class Stretch>
std::int64_t step_to_begin_at(MpiWorld const& world, Checkpoint const& checkpoint,
                              std::vector<Stretch> const& stretches, bool resume, std::string const& why) {
  std::int64_t const done = step_to_begin_at(world, checkpoint, resume);
  if (done != steps_of(stretches) &&
      std::ranges::none_of(stretches, [&](Stretch const& s) { return s.first_step == done; }))
    throw InputError(
        fmt::format("--resume: the checkpoint '{}' stands at step {}, which this run of {} steps "
                    "does not pass: {}",
                    checkpoint.restart_file.string(), done, steps_of(stretches), why));
  return done;
}

} // namespace mesobridge::md
