#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/measurement.hpp"
#include "sdpd/state/checkpoint.hpp"
#include "sdpd/state/pair_counts.hpp"
#include "sdpd/state/snapshot.hpp"
#include <memory>

namespace mesobridge::sdpd {

struct System;

/// An SDPD, DPDE or DPD fluid in a box, integrated by Velocity Verlet and a
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
  /// The components of a measurement of observe/list.hpp, reduced.
  std::vector<double> measure(Measurement const& measurement) const;
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
  /// The larger of bond_order().crystal and lattice_order(), see observe/.
  double crystal_fraction() const;

  /// The walls of the box, with what they have done so far.
  std::vector<Wall> const& walls() const;
  double wall_time() const; ///< since they began to move
  /// Moving walls wait where they are, and body forces do not act, until they are let go.
  void hold_walls(bool hold);

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
  std::unique_ptr<System> system_;
  std::vector<SubStep> sub_steps_;
};

} // namespace mesobridge::sdpd
