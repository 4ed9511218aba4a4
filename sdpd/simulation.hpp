#pragma once
#include "fitting/eos/list.hpp"
#include "sdpd/kernel/list.hpp"
#include "sdpd/observe/observation.hpp"
#include "sdpd/pair_fluid.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/thermodynamics.hpp"
#include <array>
#include <functional>
#include <memory>
#include <string>

namespace mesobridge::sdpd {

struct System;

/// A fluid at equilibrium: what `Simulation` is built from. Quantities in the units of the equation of state
/// (SI, but for reduced models), except where it says reduced.
struct SimulationSettings {
  fitting::AnyEos eos = fitting::IdealGas(1);
  double rho = 0; ///< mean density, > 0
  double T = 0;   ///< set temperature, > 0
  double K = 0;   ///< size of a particle in atoms or molecules, >= 1 and with a heat capacity above k_B/2
  CentreOfMass centre_of_mass = CentreOfMass::free; ///< without noise it makes no difference: bulk
  std::array<std::uint32_t, 3> lattice{10, 10,
                                       10}; ///< particles along each edge of the initial cubic lattice
  double disorder =
      0; ///< standard deviation of the initial displacements from it, in lattice spacings, 0 ... 0.5
  std::string kernel = "wendland-c4"; ///< one of kernel_names(); see observe/pairing.hpp
  DensityCorrection density_correction = {};
  double h_factor = 2.5; ///< support h = h_factor (m/rho)^(1/3); 2.5 gives about 65 neighbours
  double eta = 0;        ///< shear viscosity
  double zeta = 0;       ///< bulk viscosity, < 5 eta/3
  double kappa = 0;      ///< thermal conductivity of SDPD; 0: no heat conduction
  bool noise = true;     ///< false: viscous smoothed particle hydrodynamics, which starts at rest
  double skin = 0;       ///< of the neighbour lists, reduced; 0: chosen from dt and K
  double dt = 0;         ///< time step, reduced, > 0
  Scheme scheme = {};
  double bath_rate = 0; ///< of the Langevin bath during equilibration, reduced, >= 0; 0: by rescaling
  std::uint64_t seed = 1;
  int threads = 1;
  /// For DPD and DPDE. The equation of state, K, the kernel, density correction, support and viscosities
  /// above are SDPD's: they are not used then; rho is the mass per volume.
  std::optional<PairFluid> pair_fluid = {};

  ReducedUnits units() const;
  double spacing() const; ///< mean distance between particles, reduced: 1 for SDPD
  double range() const;   ///< of the interaction, reduced
  bool conducts() const;  ///< whether particles exchange heat beside their friction
};

/// Throws InputError that names the quantity that is out of bounds.
void check(SimulationSettings const& settings);

/// The start of a simulation, for those that make sub-steps of their own: a lattice, Maxwell velocities
/// without total momentum, every particle at T; densities, energies and forces belong to them. Throws
/// InputError.
std::unique_ptr<System> make_system(SimulationSettings const& settings);

/// All that a later run needs to go on bit for bit; particles in the order of memory.
struct Checkpoint {
  std::uint64_t step = 0;
  std::vector<std::uint32_t> id;
  std::vector<Vec3> q, q_at_renewal, p;
  std::vector<double> eps, S, T;
  double kept_energy = 0; ///< see Scheme::keep_energy
  PairCounts pair_counts, conduction_counts;
};

/// Per-particle values in the order of the ids, reduced.
struct Snapshot {
  std::vector<Vec3> q; ///< in the box
  std::vector<Vec3> p;
  std::vector<double> eps, rho, T, P; ///< empty where the method has none
  std::vector<double> virial = {};    ///< see observe/virials.hpp; empty unless it was asked for
};

/// An SDPD, DPDE or DPD fluid in a periodic box, integrated by Velocity Verlet and a
/// scheme for fluctuation and dissipation. All results in reduced units
/// (units()). Results are identical to the bit for any number of threads.
class Simulation {
 public:
  /// Cubic lattice, Maxwell velocities without total momentum, every particle at T. Throws InputError that
  /// names the quantity that is out of bounds.
  explicit Simulation(SimulationSettings const& settings);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Throws PhysicsError when a particle leaves the equation of state or turns unstable.
  void advance(std::uint64_t steps);

  std::uint64_t step() const; ///< steps since the start
  Observation observe() const;
  Snapshot snapshot() const;
  /// The same with the particles' virials, for which DPD and DPDE look at all pairs again.
  Snapshot snapshot_with_virials() const;
  ReducedUnits const& units() const { return units_; }
  bool has_noise() const { return has_noise_; }
  Box const& box() const;
  std::size_t size() const;
  bool has_thermostat() const; ///< DPD: friction and noise keep the set temperature, not the energy
  double neighbours() const;   ///< mean number per particle within the kernel's support
  std::uint64_t list_renewals() const;
  /// Steps of pairs since the start, and those that were not made.
  PairCounts pair_counts() const;
  PairCounts conduction_counts() const; ///< the same of heat conduction

  /// Heats all particles by one factor of their temperatures, with as much energy as would raise every one by
  /// `rise` (reduced).
  void heat(double rise);
  /// Total heat capacity dE/dT, internal and kinetic, in k_B.
  double heat_capacity() const;
  void scale_momenta(double factor);
  /// Couples the particles for one time step to a Langevin bath at the set temperature, with the settings'
  /// bath_rate. Does not conserve energy.
  void couple_to_bath();
  double bath_rate() const { return bath_rate_; }
  /// Draws every particle's temperature anew from its equilibrium law at its density, a Gaussian of relative
  /// width (k_B/C)^(1/2) about the set one (from K = 50 or, for DPDE, C = 50 k_B on; smaller particles, which
  /// settle fast, get the set temperature).
  void draw_temperatures();

  /// Other constants of the densities, at the same positions, momenta and temperatures; energies follow.
  void set_density_correction(DensityCorrection const& correction);
  /// See observe/compression.hpp.
  double compression_response() const;
  /// See observe/pairing.hpp.
  double pairing_fraction() const;

  Checkpoint checkpoint() const;
  /// Throws InputError when the checkpoint does not belong to these settings.
  void restore(Checkpoint const& checkpoint);
  /// Begins where another simulation of as many particles was, with lists and a time step of its own: the
  /// same state, but not the same bits as the other's next steps. Throws InputError as restore does.
  void begin_from(Checkpoint const& checkpoint);

 private:
  bool has_noise_;
  double bath_rate_;
  ReducedUnits units_;
  double dt_;
  Scheme scheme_;
  std::unique_ptr<System> system_;
};

/// Brings a fresh simulation to equilibrium at its set temperature. One with a thermostat simply runs. Else:
/// runs of growing length, after each of which the difference between the mean temperature of the run and the
/// set one is taken out as heat. Ends with a microcanonical system whose mean temperature is the set one
/// within the noise of the last run (half of all steps). Without noise only the mean internal temperature is
/// set. With a bath_rate the first half of the steps is coupled to the bath instead. `keep_going` is asked
/// now and then; when it says no, Interrupted is thrown.
void equilibrate(Simulation& simulation, std::uint64_t steps, std::function<bool()> const& keep_going);

} // namespace mesobridge::sdpd
