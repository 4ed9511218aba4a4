#pragma once
#include "md/star_consumers.hpp"
#include "md/star_polymer.hpp"
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::md {

/// How the isolated molecules move.
enum class VacuumEnsemble {
  canonical,     ///< at set temperatures; momentum zero, angular momentum free
  microcanonical ///< at set intrinsic energies, without any thermostat: angular momentum stays what it is
};

/// Many isolated stars at once, each at rest in a cell of its own, in Lennard-Jones units.
struct StarVacuumSettings {
  StarPolymer star;
  VacuumEnsemble ensemble = VacuumEnsemble::canonical;
  /// Temperatures, or intrinsic energies; molecule m has number m % size.
  std::vector<double> levels = {0.85, 1.0, 1.18};
  int molecules = 600;
  double dt = 0.001;               ///< time step
  std::int64_t redraw_every = 500; ///< steps between two draws of the velocities
  std::int64_t equilibration_steps = 10000;
  std::int64_t sampling_steps = 60000;
  std::int64_t sample_every = 250;       ///< steps
  std::int64_t checkpoint_every = 20000; ///< steps
  std::uint64_t seed = 1;
  std::filesystem::path directory = "."; ///< exists; gets LAMMPS's log and the checkpoint

  /// The files' name without an extension: both ensembles may lie in one directory.
  std::string stem() const { return ensemble == VacuumEnsemble::canonical ? "vacuum" : "vacuum-nve"; }
  std::filesystem::path log_file() const { return directory / ("lammps-" + stem() + ".log"); }
  std::filesystem::path restart_file() const { return directory / (stem() + ".restart"); }
  double level(std::int64_t molecule) const { return levels[std::size_t(molecule) % levels.size()]; }
  /// What decides the run, in one line: a run may be resumed by equal settings only.
  std::string fingerprint() const;
};

/// Throws InputError that names the quantity when the settings make no sense.
void check(StarVacuumSettings const& settings);

/// Samples isolated molecules. Canonical: velocities are drawn anew from Maxwell's law at intervals and freed
/// from the molecule's own total momentum (so P = 0 exactly and L takes part in the equilibrium), between
/// them the molecule moves freely: this samples exp(-U/T) on the states of zero momentum, up to the time
/// step's error. Microcanonical: the velocities are scaled once so that U is the set energy. With `resume`
/// and a checkpoint only what is left of the run is made, equal bit for bit to the unbroken run's (on as many
/// ranks). All ranks call it together. Returns false when a consumer stopped it. Throws InputError,
/// LammpsError, and PhysicsError for an unstable run, a molecule that has left its cell, an energy below the
/// potential energy.
bool sample_star_vacuum(MpiWorld const& world, StarVacuumSettings const& settings, bool resume,
                        StarConsumers const& consumers);

} // namespace mesobridge::md
