#pragma once
#include "sdpd/lammps/rank_particles.hpp"
#include "sdpd/method/parts.hpp"
#include "sdpd/method/settings.hpp"

namespace mesobridge::sdpd {

/// The physics of one rank's part of a DPD or DPDE fluid of one species, by the laws of the built-in engine:
/// velocity Verlet (sdpd/README.md, Eq. (S28)) and the explicit step of all pairs at once (S25). Pairs are
/// worked on eight at a time in double precision, noise is that of (seed, step, ids): results depend on the
/// ranks by round-off alone. Reduced units.
class DecomposedFluid {
 public:
  /// Of each particle what travels with it beside position and velocity.
  struct Carried {
    double eps = 0, T = 1;
  };

  /// The settings are such as refuse_for_lammps() lets through.
  explicit DecomposedFluid(SimulationSettings const& settings);

  bool has_energies() const { return parts_.thermodynamics != nullptr; }
  double range() const { return range_; }
  double skin() const { return skin_; }
  double dt() const { return dt_; }

  /// In the order of RankParticles; whoever moves particles in memory or to other ranks moves these.
  std::vector<Carried> carried;

  void kick(RankParticles const& particles) const;
  /// Half a kick, and positions that follow.
  void kick_and_drift(RankParticles const& particles, double* q) const;
  /// The pairs' forces, added to `f`, also of ghosts, whose shares have still to go to their owners. Throws
  /// PhysicsError.
  void add_forces(RankParticles const& particles, std::uint64_t step);
  /// Friction and noise of this step, if it is their turn. Throws PhysicsError.
  void fluctuate(RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step);

 private:
  template <class Law>
  void fluctuate(Law const& law, RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step);
  template <class Law, class F>
  void for_each_change(Law const& law, RankParticles const& particles, std::uint64_t step, F const& f) const;
  void add_heat(RankParticles const& particles, std::uint64_t step);
  void stop_at(Failure const& failure, std::uint64_t step) const;

  MethodParts parts_;
  double range_, skin_, dt_;
  std::uint32_t fluctuate_every_;
  std::uint64_t seed_;
  std::size_t row_;           ///< numbers of a particle at the start: velocity and, in DPDE, temperature
  std::vector<double> start_; ///< rows of them
  std::vector<SixteenPairs> pairs_; ///< in range at the positions of the forces
  std::vector<double> impulse_, heat_;
  Particles own_; ///< for the thermodynamics
};

} // namespace mesobridge::sdpd
