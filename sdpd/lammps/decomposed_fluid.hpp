#pragma once
#include "sdpd/fluctuation/pair_lanes.hpp"
#include "sdpd/lammps/block_sweep.hpp"
#include "sdpd/lammps/rank_pairs.hpp"
#include "sdpd/method/parts.hpp"
#include "sdpd/method/settings.hpp"

namespace mesobridge::sdpd {

/// The physics of one rank's part of a fluid of one species, by the laws of the built-in engine: velocity
/// Verlet (sdpd/README.md, Eq. (S28)) with forces of a pair potential or of pressures (S9), and the explicit
/// step of all pairs at once (S25) or one pair after the other (S98). Pairs are worked on eight at a time in
/// double precision, noise is that of (seed, step, ids): results depend on the ranks by round-off alone.
/// Reduced units.
class DecomposedFluid {
 public:
  /// Of each particle what travels with it beside position and velocity.
  struct Carried {
    double eps = 0, T = 1, S = 0;
  };

  /// The settings are such as refuse_for_lammps() lets through.
  explicit DecomposedFluid(SimulationSettings const& settings);

  bool has_energies() const { return parts_.thermodynamics != nullptr; }
  bool has_densities() const { return std::holds_alternative<SdpdLaw>(parts_.law); }
  double range() const { return range_; }
  double skin() const { return skin_; }
  /// How far from its part of the box a rank has to see particles, with the skin.
  double reach() const { return (blocks_ ? std::max(range_, blocks_->reach()) : range_) + skin_; }
  double dt() const { return dt_; }
  Vec3 box_edge() const { return box_edge_; }
  /// Of the pairs that this rank has stepped in turn since it was asked before.
  PairCounts take_counts() { return std::exchange(counts_, {}); }

  /// In the order of RankParticles; whoever moves particles in memory or to other ranks moves these.
  std::vector<Carried> carried;

  void kick(RankParticles const& particles) const;
  /// Half a kick, and positions that follow.
  void kick_and_drift(RankParticles const& particles, double* q) const;
  /// The pairs' forces, added to `f`, also of ghosts, whose shares have still to go to their owners. The
  /// first time energies are what is known of the particles, afterwards SDPD goes on at constant entropies.
  /// Throws PhysicsError.
  void add_forces(RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step);
  /// Friction and noise of this step, if it is their turn; SDPD has new pressures then, and the forces of
  /// them. Throws PhysicsError.
  void fluctuate(RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step);

 private:
  enum class Given { energies, entropies };

  void add_pair_forces(RankParticles const& particles, Failure& failure);
  void find_densities(RankParticles const& particles, GhostExchange& ghosts);
  void add_pressure_forces(RankParticles const& particles, GhostExchange& ghosts);
  /// Temperatures and, where there are densities, pressures, by the thermodynamics of the own particles.
  void renew_thermodynamics(std::size_t owned, Given given, std::uint64_t step);

  template <class Law>
  void fluctuate(Law const& law, RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step);
  template <class Law>
  void start(RankParticles const& particles, GhostExchange& ghosts);
  template <class Law, class F>
  void for_each_change(Law const& law, RankParticles const& particles, std::uint64_t step, F const& f) const;
  template <class Law>
  void step_in_turn(Law const& law, RankParticles const& particles, GhostExchange& ghosts,
                    std::uint64_t step);
  template <class Law>
  void find_heat(std::size_t all, GhostExchange& ghosts);
  void add_heat(RankParticles const& particles, std::uint64_t step);
  void take_in(RankParticles const& particles, std::uint64_t step);
  void stop_at(Failure const& failure, std::uint64_t step) const;

  MethodParts parts_;
  double range_, skin_, dt_;
  Vec3 box_edge_;
  std::uint32_t fluctuate_every_;
  std::uint64_t seed_;
  Given given_ = Given::energies;
  PairScheme scheme_ = PairScheme::ssa; ///< where pairs are stepped in turn
  PairCounts counts_;
  RankPairs pairs_;       ///< in range at the positions of the forces
  std::vector<Row> rows_; ///< those positions and P/rho^2
  std::vector<double> rho_;
  std::vector<double> start_;               ///< rows of what friction and noise begin from
  std::vector<Row> sums_;                   ///< of forces or impulses
  std::vector<VectorLanes<Lanes>> changes_; ///< of the pairs' momenta, kept: they cost more than their memory
  std::vector<Row> mean_;                   ///< velocities, of start and end
  std::vector<double> heat_;
  std::optional<BlockSweep> blocks_; ///< where pairs are stepped one after the other
  Particles own_;                    ///< for the thermodynamics
};

} // namespace mesobridge::sdpd
