#pragma once
#include "md/star_consumers.hpp"
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::md {

/// What a melt is made of, and how LAMMPS gets it. LAMMPS's atom ids are molecule * atoms + 1 + number in the
/// molecule. All ranks make the same calls.
class MeltSystem {
 public:
  MeltSystem() = default;
  MeltSystem(MeltSystem const&) = delete;
  MeltSystem& operator=(MeltSystem const&) = delete;
  virtual ~MeltSystem() = default;

  virtual std::string name() const = 0; ///< for messages: "6-3"
  virtual int molecules() const = 0;
  virtual int atoms_per_molecule() const = 0;
  virtual std::vector<double> masses() const = 0; ///< of a molecule's atoms, in order
  /// Atoms per volume as the run begins.
  virtual double first_density() const = 0;
  /// The edges of the box at a density.
  virtual Vec3 edges(double rho) const = 0;

  /// LAMMPS's units and styles, before there are atoms.
  virtual void prepare(LammpsSession& lammps) const = 0;
  virtual void create(MpiWorld const& world, LammpsSession& lammps) const = 0;
  /// The forces, for a session whose atoms have just been created or read.
  virtual void set_forces(LammpsSession& lammps) const = 0;
  /// Called once, when the forces are set for the first time, before the atoms get their velocities. It asks
  /// `goes_on` often, and ends with false when that says so.
  virtual bool relax(LammpsSession&, std::function<bool()> const& /*goes_on*/) const { return true; }
  /// What follows the message that the time step is too long.
  virtual std::string shorter_step() const = 0;

  double atoms() const { return double(molecules()) * atoms_per_molecule(); }
};

/// How a melt comes to its state and is sampled: brought to its density step by step under a Langevin
/// thermostat, equilibrated, then sampled at constant energy with no total momentum. In LAMMPS's units.
struct MeltProtocol {
  double rho = 0;       ///< atoms per volume
  double T = 1;         ///< of the thermostat
  double friction = 1;  ///< of the thermostat [1/time]
  double dt = 0.001;    ///< time step
  double squeeze = 1.3; ///< the density changes by at most this factor at once
  std::int64_t squeeze_steps = 1000;
  std::int64_t equilibration_steps = 0, sampling_steps = 0, sample_every = 0, checkpoint_every = 0;
  std::uint64_t seed = 1;
  std::filesystem::path log_file, restart_file;
};

/// What settings of melts say alike; the rest is left to the caller.
template <class Settings>
MeltProtocol protocol_of_run(Settings const& s) {
  MeltProtocol protocol;
  protocol.squeeze = s.squeeze, protocol.squeeze_steps = s.squeeze_steps, protocol.seed = s.seed;
  protocol.equilibration_steps = s.equilibration_steps, protocol.sampling_steps = s.sampling_steps;
  protocol.sample_every = s.sample_every, protocol.checkpoint_every = s.checkpoint_every;
  protocol.log_file = s.log_file(), protocol.restart_file = s.restart_file();
  return protocol;
}

/// Throws InputError where steps and thermostat make no sense, whatever the units are.
void check_run(MeltProtocol const& protocol);

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
std::vector<MeltStretch> plan(MeltProtocol const& protocol, double first_density);

/// Makes the stretches of a run that are left after its checkpoint, if it is resumed, or all. Otherwise as
/// sample_melt; `why` ends the refusal of a checkpoint that none of them begins at.
bool run_stretches(MpiWorld const& world, MeltSystem const& system, MeltProtocol const& protocol,
                   std::vector<MeltStretch> const& stretches, bool resume, std::string const& why,
                   StarConsumers const& consumers);

/// Makes the run, or what is left of it when `resume` and a checkpoint is there. All ranks call it together.
/// Returns false when a consumer stopped it. Throws InputError, LammpsError, and PhysicsError when the run
/// became unstable or lost more than 0.01 k_B T an atom of energy.
bool sample_melt(MpiWorld const& world, MeltSystem const& system, MeltProtocol const& protocol, bool resume,
                 StarConsumers const& consumers);

} // namespace mesobridge::md
