#pragma once
#include "sdpd/conduction/heat_conduction.hpp"
#include "sdpd/friction/list.hpp"
#include "sdpd/kinetics/list.hpp"
#include "sdpd/neighbours/neighbours.hpp"
#include "sdpd/potential/list.hpp"
#include "sdpd/state/body_force.hpp"
#include "sdpd/state/pair_counts.hpp"
#include "sdpd/state/species.hpp"
#include "sdpd/state/wall.hpp"
#include "sdpd/thermodynamics/thermodynamics.hpp"
#include "sdpd/threads/team.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::sdpd {

/// Everything that the sub-steps of a scheme work on: particles of one species or several in a box,
/// in reduced units (sdpd/README.md, Eq. (S1)), where the mass is 1 and k_B = 1/K.
struct System {
  /// What a reaction begins from, in each part of a time step.
  struct ReactionStart {
    std::vector<double> progress, eps;
  };

  Box box;
  std::vector<Species> species;                         ///< none for one species of mass 1
  std::vector<std::uint32_t> species_of_id;             ///< empty then
  std::unique_ptr<Thermodynamics const> thermodynamics; ///< none in DPD
  AnyKernel kernel;                                     ///< SDPD
  double self_density;                                  ///< what a particle adds to its own density
  DensitySum density_sum = DensitySum::mass;
  AnyPotential potential;   ///< DPD, DPDE
  AnyPairLaw law;           ///< friction and noise
  AnyConduction conduction; ///< of heat, SDPD and DPDE
  Neighbours neighbours;
  std::vector<Wall> walls;         ///< at those faces of the box that have one
  std::vector<WallCorner> corners; ///< where walls of several axes meet
  BodyForce body_force;
  std::optional<Reaction> reaction; ///< that turns the particles from reactant into product
  Particles particles;
  double boltzmann;
  std::uint64_t seed;
  int threads;
  std::uint64_t step = 0;           ///< steps done; part of the noise's counter
  double dt = 0;                    ///< time step under way, for messages
  double wall_time = 0;             ///< since the walls began to move
  bool walls_held = false;          ///< they wait, and so do their time and the body force
  double body_work = 0;             ///< done on the fluid by the body force
  double sink_heat = 0;             ///< given to the fluid where Scheme::keep_energy takes that work out
  double reaction_time = 0;         ///< since the reaction began
  double virial = 0;                ///< sum over pairs of f_ij . r_ij at the last evaluation of the forces
  std::uint64_t renewals = 0;       ///< of the lists, since the start
  PairCounts pair_counts;           ///< since the start
  PairCounts conduction_counts;     ///< the same of heat conduction
  double kept_energy = 0;           ///< the total energy that Scheme::keep_energy restores
  double potential_energy = 0;      ///< of the pair potential
  std::vector<double> block_virial; ///< parts of both, kept so that no step allocates
  std::vector<double> block_energy;
  std::vector<double> energy_gain; ///< of the particles since their caloric expansions began, during a sweep
  std::vector<Rates> rates;        ///< of the reaction, found last; by id, so that no new order moves them
  ReactionStart reaction_start;
  std::vector<Vec3> impulse; ///< given to the particles by a sweep of SER

  std::size_t size() const { return particles.size(); }

  /// Gives the particles the species and masses that go with their ids.
  void label_particles() {
    for (std::size_t i = 0; i < species_of_id.size(); ++i) {
      particles.species[i] = species_of_id[particles.id[i]];
      particles.mass[i] = species[particles.species[i]].mass;
    }
  }

  /// Impulse that the walls have given.
  Vec3 wall_impulse() const {
    Vec3 sum;
    for (auto const& wall : walls)
      component(sum, wall.axis) += wall.impulse, sum += wall.drag;
    return sum;
  }
  double wall_work() const {
    return std::accumulate(walls.begin(), walls.end(), 0.0,
                           [](double sum, Wall const& wall) { return sum + wall.work; });
  }
  /// What the fluid has got from outside: work and heat of its walls, work of the body force.
  double energy_given() const {
    double heat = 0;
    for (auto const& wall : walls)
      heat += wall.heat;
    return wall_work() + heat + body_work + sink_heat;
  }
  /// Between the walls; that of the box where there are none.
  double volume() const {
    double volume = box.volume();
    for (auto const& wall : walls)
      volume -= (wall.upper ? -1 : 1) * wall.motion.way_at(wall_time) * box.volume() /
                component(box.edge, wall.axis);
    return volume;
  }

  /// Whether neighbours count by their masses in the density of a particle.
  bool sums_masses() const { return !particles.mass.empty() && density_sum == DensitySum::mass; }
  bool has_densities() const { return std::holds_alternative<SdpdLaw>(law); }
  bool has_energies() const {
    return std::visit([](auto const& of) { return of.has_energies; }, law);
  }

  /// Throws PhysicsError that names the particle, the step and the time step, if there was a failure.
  void stop_at(Failure const& failure) const {
    if (failure.any())
      throw PhysicsError(fmt::format("particle {} at step {} (dt = {:.6g} reduced): {}", failure.id(), step,
                                     dt, failure.message()));
  }
};

/// Sets a quantity of all particles, each by the thread that works on it elsewhere, whose cache it stays in.
template <class T>
void set_all(System const& system, std::vector<T>& values, T const& value) {
  values.resize(system.size());
  for_each_index(values.size(), system.threads, [&](std::size_t i) { values[i] = value; });
}

/// Particles that are worked on by one thread at a time.
inline constexpr std::size_t range_length = 512;

/// Calls f(range) for all particles in parts, on all threads.
template <class F>
void for_each_range(System const& system, F&& f) {
  for_each_index((system.size() + range_length - 1) / range_length, system.threads, [&](std::size_t k) {
    f(Range{k * range_length, std::min((k + 1) * range_length, system.size())});
  });
}

} // namespace mesobridge::sdpd
