#pragma once
#include "md/lammps_session.hpp"
#include <algorithm>

/// What runs at a set temperature have in common, whatever their atoms are.
namespace mesobridge::md {

/// Throws InputError where a run's steps make no sense.
inline void check_steps(std::int64_t equilibration, std::int64_t sampling, std::int64_t sample_every) {
  require(equilibration > 0, "equilibration steps", equilibration, "must be > 0");
  require(sample_every > 0, "steps between samples", sample_every, "must be > 0");
  require(sampling >= sample_every, "sampling steps", sampling, "must be at least the steps between samples");
}

/// The time step, the thermostat (md/README.md, Eq. (M3)) and the motion from here on, in place of earlier
/// ones; in LAMMPS's units. The bath comes before the motion, as its discretisation demands.
inline void set_bath(LammpsSession& lammps, double T, double dt, double relaxation_time, int seed) {
  lammps.command("timestep {}", dt);
  lammps.command("fix bath all langevin {0} {0} {1} {2} gjf vhalf", T, relaxation_time, seed);
  lammps.command("fix move all nve");
}

/// Runs on by some steps, in pieces short enough that whoever watches can stop the run soon: run(n) makes a
/// piece of n steps, goes_on(n) says whether another may follow. False when it may not.
template <class Run, class GoesOn>
bool run_in_pieces(std::int64_t steps, Run const& run, GoesOn const& goes_on) {
  constexpr std::int64_t piece = 50;
  for (std::int64_t done = 0; done < steps;) {
    std::int64_t const next = std::min(piece, steps - done);
    run(next);
    done += next;
    if (!goes_on(next))
      return false;
  }
  return true;
}

} // namespace mesobridge::md
