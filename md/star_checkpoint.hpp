#pragma once
#include "md/lammps_session.hpp"
#include "md/star_polymer.hpp"
#include <cstdint>
#include <filesystem>
#include <functional>

namespace mesobridge::md {

/// Writes a checkpoint of the session into a new file, lets the others put in safety what belongs to it, and
/// only then lets the new file take the old one's place. All ranks must call it.
void write_checkpoint(MpiWorld const& world, LammpsSession& lammps, std::filesystem::path const& file,
                      std::function<void()> const& before_it_counts);

/// The step that a run begins at: that of its checkpoint when it is resumed, or else 0, and an old checkpoint
/// is removed. All ranks must call it.
std::int64_t step_to_begin_at(MpiWorld const& world, StarPolymer const& star,
                              std::filesystem::path const& file, std::filesystem::path const& log,
                              bool resume);

} // namespace mesobridge::md
