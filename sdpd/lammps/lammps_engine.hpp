#pragma once
#include "md/mpi_world.hpp"
#include "sdpd/simulation.hpp"
#include <filesystem>

namespace mesobridge::sdpd {

/// What of a simulation the engine inside LAMMPS cannot run, in words that begin with the name of the
/// setting; empty where it can. All of the list, in its order.
std::vector<std::string> lammps_refusals(SimulationSettings const& settings);

/// Throws InputError with the first of them.
void refuse_for_lammps(SimulationSettings const& settings);

/// Advances a simulation by LAMMPS's domain decomposition on all MPI ranks. The first rank holds the whole
/// Simulation, which observes, measures and writes; the others wait in serve() for its steps. Constructed on
/// all ranks with the same settings.
class LammpsEngine {
 public:
  LammpsEngine(md::MpiWorld const& world, SimulationSettings const& settings,
               std::filesystem::path const& log_file);
  /// On the first rank: lets the others return from serve().
  ~LammpsEngine();
  LammpsEngine(LammpsEngine const&) = delete;
  LammpsEngine& operator=(LammpsEngine const&) = delete;

  /// On the first rank, before its first step: takes constants of the densities and viscosities of the pairs
  /// from the settings that the run has come to; the other ranks need not know them.
  void settle(SimulationSettings const& settings);

  /// On the first rank. The first call begins where the simulation is; later ones go on from the state that
  /// the ranks hold, which is the simulation's unless someone has changed it. Throws PhysicsError,
  /// md::LammpsError.
  void advance(Simulation& simulation, std::uint64_t steps);

  /// Time on the wall that steps have taken so far, without what brings the particles to the ranks and back.
  double seconds_in_steps() const;

  /// On the other ranks: takes part in the first one's steps until it ends.
  void serve();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

} // namespace mesobridge::sdpd
