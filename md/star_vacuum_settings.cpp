#include "md/canonical_run.hpp"
#include "md/star_checkpoint.hpp"
#include "md/star_vacuum.hpp"
#include <cmath>
#include <fmt/ranges.h>

namespace mesobridge::md {

std::string StarVacuumSettings::fingerprint() const {
  return fmt::format(
      "{} in vacuum, {} at {}, {} molecules, time step {}, "
      "velocities drawn every {} steps, {} + {} steps, a sample every {} steps, a checkpoint every {}, seed "
      "{}",
      md::fingerprint(star), ensemble == VacuumEnsemble::canonical ? "canonical" : "microcanonical",
      fmt::join(levels, ", "), molecules, dt, redraw_every, equilibration_steps, sampling_steps, sample_every,
      checkpoint_every, seed);
}

void check(StarVacuumSettings const& settings) {
  check(settings.star);
  require(settings.star.atoms() >= 3, "atoms of a star", settings.star.atoms(), "must be at least 3");
  require(!settings.levels.empty(), "temperatures or energies", settings.levels.size(),
          "at least one is needed");
  for (double level : settings.levels)
    require(level > 0 && std::isfinite(level), "temperature or energy", level, "must be > 0");
  require(settings.molecules >= int(settings.levels.size()) && settings.molecules <= 1000000, "molecules",
          settings.molecules, "must be at least one a temperature or energy, at most 1000000");
  require(settings.dt > 0 && settings.dt <= 0.02, "time step", settings.dt,
          "must be in (0, 0.02]; the thesis takes 0.001");
  require(settings.redraw_every > 0, "steps between draws of the velocities", settings.redraw_every,
          "must be > 0");
  check_steps(settings.equilibration_steps, settings.sampling_steps, settings.sample_every);
  require(settings.checkpoint_every > 0, "steps between checkpoints", settings.checkpoint_every,
          "must be > 0");
}

} // namespace mesobridge::md
