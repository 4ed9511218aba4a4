#include "sdpd/scheme/scheme.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/conservative/pair_forces.hpp"
#include "sdpd/fluctuation/conduction.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/system/sum_over_particles.hpp"
#include "sdpd/system/total_energy.hpp"

namespace mesobridge::sdpd {
namespace {

/// The forces at new positions: by densities at constant entropies (SDPD), or from the pair potential.
void follow_positions(System& system) {
  if (!system.has_densities())
    return find_pair_forces(system);
  find_pairs_and_densities(system);
  thermodynamics_from_entropy(system);
  find_forces(system);
}

/// Temperatures, and the forces that depend on them, at new internal energies.
void follow_energies(System& system) {
  if (system.has_energies())
    thermodynamics_from_energy(system);
  if (system.has_densities())
    find_forces(system);
}

/// Kicks and moves the particles and finds the forces of their new places, at constant entropies.
void kick_and_move(System& system, double kick_dt, double dt) {
  kick_and_drift(system, kick_dt, dt);
  refresh_lists(system);
  follow_positions(system);
}

void verlet_step(System& system, double dt) {
  kick_and_move(system, dt / 2, dt);
  kick(system, dt / 2);
}

/// McLachlan's integrator (sdpd/README.md, Eq. (S29)), of two stages and the least error among such ones.
/// Symplectic and time-reversible, as Verlet is.
void two_stage_step(System& system, double dt) {
  constexpr double outer = 0.1931833275037836;
  kick_and_move(system, outer * dt, dt / 2);
  kick_and_move(system, (1 - 2 * outer) * dt, dt / 2);
  kick(system, outer * dt);
}

void conservative_step(System& system, Conservative conservative, double dt) {
  switch (conservative) {
  case Conservative::verlet:
    return verlet_step(system, dt);
  case Conservative::two_stage:
    return two_stage_step(system, dt);
  case Conservative::none:
    return;
  }
}

/// Brings the total energy back to what it was, with one factor for all particles' temperatures (Eq. (S30)),
/// so that small cold ones stay above zero.
void restore_energy(System& system) {
  auto& particles = system.particles;
  double const missing = system.kept_energy - total_energy(system);
  auto const heat = [&](std::size_t i) { return particles.T[i] / particles.caloric[i].inverse_C_0; };
  double const factor = missing / sum_over_particles(system, heat);
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
      particles.eps[i] += factor * heat(i);
  });
}

/// Fluctuation and dissipation, then conduction; the other way round in the second half of a symmetric step.
void fluctuation_step(System& system, Scheme const& scheme, double dt, bool second) {
  bool const conducts = !std::holds_alternative<std::monostate>(system.conduction);
  if (conducts && second) {
    conduct(system, scheme.pairs, dt, second);
    thermodynamics_from_energy(system);
  }
  fluctuate(system, scheme.pairs, dt, second);
  if (conducts && !second) {
    thermodynamics_from_energy(system);
    conduct(system, scheme.pairs, dt, second);
  }
  if (scheme.keep_energy)
    restore_energy(system);
  follow_energies(system);
}

} // namespace

void step(System& system, Scheme const& scheme, double dt) {
  system.dt = dt;
  bool const strang = scheme.splitting == Splitting::strang;
  double const sweep_dt = scheme.verlet_steps * dt * (strang ? 0.5 : 1);
  if (strang && system.step % scheme.verlet_steps == 0)
    fluctuation_step(system, scheme, sweep_dt, false);
  conservative_step(system, scheme.conservative, dt);
  if ((system.step + 1) % scheme.verlet_steps == 0)
    fluctuation_step(system, scheme, sweep_dt, strang);
  ++system.step;
}

} // namespace mesobridge::sdpd
