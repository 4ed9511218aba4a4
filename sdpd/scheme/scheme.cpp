#include "sdpd/scheme/scheme.hpp"
#include "md/error.hpp"
#include "sdpd/boundary/wall_friction.hpp"
#include "sdpd/conservative/body_force.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/conduction.hpp"
#include "sdpd/reaction/reaction.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/system/conservation.hpp"
#include "sdpd/system/sum_over_particles.hpp"
#include "sdpd/system/total_energy.hpp"

namespace mesobridge::sdpd {
namespace {

using enum Conserved;

SubStep temperatures() {
  return {.name = "temperatures and pressures at the new energies",
          .conserves = {positions, momenta, internal_energies},
          .run = thermodynamics_from_energy};
}

SubStep forces_of_pressures() {
  return {.name = "forces at the new pressures",
          .conserves = {positions, momenta, internal_energies, entropies},
          .run = find_forces};
}

std::vector<Stream> streams(std::vector<SweepStream> const& noise, bool second) {
  std::vector<Stream> of_sweep;
  for (auto const& one : noise)
    of_sweep.push_back(one.of(second));
  return of_sweep;
}

SubStep fluctuation(PairIntegrator const& pairs, double dt, bool second) {
  return {.name = "fluctuation and dissipation: " + pairs.name,
          .conserves = pairs.conserves,
          .noise = streams(pairs.noise, second),
          .run = [=, sweep = pairs.sweep](System& system) { sweep(system, dt, second); }};
}

SubStep conduction(PairIntegrator const& pairs, double dt, bool second) {
  return {.name = "heat conduction",
          .conserves = {positions, momenta, internal_energy},
          .noise = streams({conduction_noise, conduction_acceptance_noise}, second),
          .run = [=, of_heat = pairs.of_heat](System& system) { conduct(system, of_heat, dt, second); }};
}

/// Brings the total energy back to what it was, with one factor for all particles' temperatures (Eq. (S30)),
/// so that small cold ones stay above zero. What a body force has done leaves the same way.
void restore_energy(System& system) {
  auto& particles = system.particles;
  system.sink_heat = -system.body_work;
  double const missing = system.kept_energy + system.energy_given() - total_energy(system);
  auto const heat = [&](std::size_t i) { return particles.T[i] / particles.caloric[i].inverse_C_0; };
  double const factor = missing / sum_over_particles(system, heat);
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
      particles.eps[i] += factor * heat(i);
  });
}

SubStep energy_restoration() {
  return {.name = "the kept energy restored", .conserves = {positions, momenta}, .run = restore_energy};
}

/// Fluctuation and dissipation, then conduction; the other way round in the second half of a symmetric step.
std::vector<SubStep> exchange(Scheme const& scheme, System const& system, double dt, bool second) {
  auto const& pairs = pair_integrator(scheme.pairs);
  bool const conducts = !std::holds_alternative<std::monostate>(system.conduction);
  std::vector<SubStep> steps{fluctuation(pairs, dt, second)};
  if (conducts)
    steps.insert(steps.end(), {temperatures(), conduction(pairs, dt, second)});
  if (has_rough_walls(system)) {
    if (conducts)
      steps.push_back(temperatures());
    steps.push_back(wall_friction(system, dt, second));
  }
  if (system.reaction) {
    if (second || !looks_back(*system.reaction))
      steps.push_back(temperatures());
    steps.push_back(reaction(system, dt));
  }
  if (second)
    std::ranges::reverse(steps);
  if (scheme.keep_energy)
    steps.push_back(energy_restoration());
  if (system.has_energies())
    steps.push_back(temperatures());
  if (system.has_densities())
    steps.push_back(forces_of_pressures());
  return steps;
}

} // namespace

void check(Scheme const& scheme, Features const& particles, bool noise) {
  require(scheme.verlet_steps >= 1, "Verlet steps for one of fluctuation and dissipation",
          scheme.verlet_steps, "must be >= 1");
  conservative_integrator(scheme.conservative);
  auto const why = refusal(pair_integrator(scheme.pairs), particles, noise);
  require(!why, "scheme", scheme.pairs, why.value_or(""));
  require(particles.energies || !scheme.keep_energy, "energy", "kept",
          "the particles have no internal energies that could give or take energy");
}

std::vector<SubStep> sub_steps(Scheme const& scheme, System const& system, double dt) {
  auto const n = scheme.verlet_steps;
  bool const strang = scheme.splitting == Splitting::strang;
  double const exchange_dt = n * dt * (strang ? 0.5 : 1);
  std::vector<SubStep> list;
  auto add = [&](std::vector<SubStep> steps, Turn turn) {
    for (auto& one : steps)
      one.turn = turn, list.push_back(std::move(one));
  };
  if (strang)
    add(exchange(scheme, system, exchange_dt, false), {.every = n, .at = 0});
  add(conservative_integrator(scheme.conservative).steps(dt), {});
  if (system.body_force.acts())
    add({body_force(dt)}, {});
  add(exchange(scheme, system, exchange_dt, strang), {.every = n, .at = n - 1});
  return list;
}

void step(System& system, std::span<SubStep const> sub_steps) {
#ifdef NDEBUG
  constexpr bool checks = false;
#else
  constexpr bool checks = true;
#endif
  for (auto const& part : sub_steps)
    if (part.turn.comes(system.step))
      checks ? run_and_check(part, system) : part.run(system);
  ++system.step;
}

void step(System& system, Scheme const& scheme, double dt) {
  system.dt = dt;
  step(system, sub_steps(scheme, system, dt));
}

} // namespace mesobridge::sdpd
