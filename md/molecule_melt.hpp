#pragma once
#include "md/melt_run.hpp"
#include "md/molecule_forces.hpp"
#include <array>
#include <optional>

namespace mesobridge::md {

/// A melt of a user's molecules in the units of their force field: minimised, brought to its density and
/// temperature under a Langevin thermostat, equilibrated, then sampled at constant energy with no total
/// momentum. Where something is not given, it is what `filled_in` says.
struct MoleculeMeltSettings {
  std::filesystem::path data, forces; ///< LAMMPS's data file, and its commands for the force field
  MoleculeStyles styles;
  std::array<int, 3> replicate{1, 1, 1};
  std::optional<double> rho;         ///< atoms per volume; not given: the data file's
  std::optional<double> T;           ///< of the thermostat; usual: 1 in lj, 300 in real and metal
  std::optional<double> friction;    ///< of the thermostat [1/time]; usual: 1/(1000 time steps)
  std::optional<double> dt;          ///< time step; usual: 0.002 in lj, 1 in real, 0.001 in metal
  bool minimise = true;              ///< before the first step
  double squeeze = 1.3;              ///< the density changes by at most this factor at once
  std::int64_t squeeze_steps = 1000; ///< of each change of the density, half of them at rest
  std::int64_t equilibration_steps = 20000;
  std::int64_t sampling_steps = 100000;  ///< at constant energy
  std::int64_t sample_every = 100;       ///< steps
  std::int64_t checkpoint_every = 10000; ///< steps, a multiple of sample_every
  std::uint64_t seed = 1;
  std::filesystem::path directory = "."; ///< exists; gets LAMMPS's log and the checkpoint

  std::filesystem::path log_file() const { return directory / "lammps.log"; }
  std::filesystem::path restart_file() const { return directory / "molecules.restart"; }
};

/// The settings with both files read, the molecules replicated, and all numbers.
class MoleculeMelt {
 public:
  /// Throws InputError that names the quantity, or the file and its line.
  explicit MoleculeMelt(MoleculeMeltSettings const& settings);

  MoleculeMeltSettings const& settings() const { return settings_; }
  MoleculeSystem const& system() const { return system_; }
  MeltProtocol const& protocol() const { return protocol_; }
  /// What decides the run, in one line: a run may be resumed by equal settings only (but for its length).
  std::string fingerprint() const;

 private:
  MoleculeMeltSettings settings_;
  MoleculeSystem system_;
  MeltProtocol protocol_;
};

/// Has LAMMPS take the force field on rank 0 alone: what it refuses is told once. All ranks must call it.
/// Throws InputError.
void try_forces(MpiWorld const& world, MoleculeMelt const& melt);

/// Makes the run, or what is left of it, as sample_star_melt. The frames tell the energies inside the
/// molecules. Throws InputError when LAMMPS refuses the force field, and PhysicsError as sample_melt.
bool sample_molecules(MpiWorld const& world, MoleculeMelt const& melt, bool resume,
                      StarConsumers const& consumers);

} // namespace mesobridge::md
