#pragma once
#include "md/star_consumers.hpp"
#include "md/star_polymer.hpp"
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::md {

/// A melt of stars in Lennard-Jones units: squeezed step by step from a dilute lattice to its density under a
/// Langevin thermostat, equilibrated, then sampled at constant energy with no total momentum (thesis, section
/// 3.2).
struct StarMeltSettings {
  StarPolymer star;
  int molecules = 1000;
  double rho = 0.3;                  ///< beads per sigma^3, (0, 0.7]
  double T = 1;                      ///< of the thermostat
  double friction = 1;               ///< of the thermostat [1/time]
  double dt = 0.001;                 ///< time step
  double squeeze = 1.3;              ///< the density grows by at most this factor at once
  std::int64_t squeeze_steps = 1000; ///< of each growth of the density, half of them at rest
  std::int64_t equilibration_steps = 20000;
  std::int64_t sampling_steps = 300000;  ///< at constant energy
  std::int64_t sample_every = 100;       ///< steps
  std::int64_t checkpoint_every = 10000; ///< steps, a multiple of sample_every
  std::uint64_t seed = 1;
  std::string name = "star-melt";        ///< of the checkpoint
  std::filesystem::path directory = "."; ///< exists; gets LAMMPS's log and the checkpoint

  std::filesystem::path log_file() const { return directory / "lammps.log"; }
  std::filesystem::path restart_file() const { return directory / (name + ".restart"); }
  /// What decides the run, in one line: a run may be resumed by equal settings only (but for its length).
  std::string fingerprint() const;
};

enum class MeltPhase { squeeze, rest, equilibrate, sample, hold };

/// A stretch of the run between two checkpoints.
struct MeltStretch {
  MeltPhase phase = MeltPhase::sample;
  std::int64_t first_step = 0, steps = 0;
  double rho = 0;      ///< at its end
  bool begins = false; ///< to hold the molecules' centres; what follows goes on with it
};

/// The whole run, stretch by stretch. Every stretch starts from a checkpoint file, of the unbroken run too,
/// so that a resumed run equals the unbroken one bit for bit (on as many ranks).
std::vector<MeltStretch> plan(StarMeltSettings const& settings);

/// Throws InputError that names the quantity when the settings make no sense.
void check(StarMeltSettings const& settings);

/// Makes the stretches of a run that are left after its checkpoint, if it is resumed, or all. Otherwise as
/// sample_star_melt; `why` ends the refusal of a checkpoint that none of them begins at.
bool run_stretches(MpiWorld const& world, StarMeltSettings const& settings,
                   std::vector<MeltStretch> const& stretches, bool resume, std::string const& why,
                   StarConsumers const& consumers);

/// Makes the run, or what is left of it when `resume` and a checkpoint is there. All ranks call it together.
/// Returns false when a consumer stopped it. Throws InputError, LammpsError, and PhysicsError when the run
/// became unstable or lost more than 0.01 k_B T a bead of energy.
bool sample_star_melt(MpiWorld const& world, StarMeltSettings const& settings, bool resume,
                      StarConsumers const& consumers);

/// The frames that a whole run delivers.
std::int64_t frames_of(StarMeltSettings const& settings);

} // namespace mesobridge::md
