#pragma once
#include "sdpd/simulation.hpp"
#include <functional>

namespace mesobridge::sdpd {

/// How far an equilibration is: with the simulation's checkpoint, all that it needs to go on bit for bit.
struct EquilibrationProgress {
  std::uint64_t done = 0;              ///< steps
  double sum_T_kin = 0, sum_T_int = 0; ///< of the present run's observations
};

/// equilibrate() in steps of the caller's, who may stop it, keep it and go on with it.
///
/// Runs of 1/32, 1/32, 1/16, 1/8, 1/4 and 1/2 of the steps, at whose ends heat is added or taken out. Walls
/// are held until the last step is done.
class Equilibration {
 public:
  /// The simulation is fresh, or where it was at this progress.
  Equilibration(Simulation& simulation, std::uint64_t steps, EquilibrationProgress const& progress = {});

  bool is_done() const { return progress_.done >= steps_; }

  /// One step and, where a run ends with it, what follows that. Throws PhysicsError.
  void advance();

  EquilibrationProgress const& progress() const { return progress_; }

 private:
  struct Part {
    std::uint64_t begin, end; ///< steps
    double share;             ///< of all
  };
  Part part() const;
  void observe(Part const& part);
  void finish(Part const& part);

  Simulation& simulation_;
  std::uint64_t steps_;
  EquilibrationProgress progress_;
};

/// Brings a fresh simulation to equilibrium at its set temperature. One with a thermostat simply runs. Else:
/// runs of growing length, after each of which the difference between the mean temperature of the run and the
/// set one is taken out as heat. Ends with a microcanonical system whose mean temperature is the set one
/// within the noise of the last run (half of all steps). Without noise only the mean internal temperature is
/// set. With a bath_rate the first half of the steps is coupled to the bath instead. `keep_going` is asked
/// now and then; when it says no, Interrupted is thrown.
void equilibrate(Simulation& simulation, std::uint64_t steps, std::function<bool()> const& keep_going);

} // namespace mesobridge::sdpd
