#include "sdpd/lammps/decomposed_fluid.hpp"
#include "sdpd/conservative/pair_forces.hpp"
#include <bit>

namespace mesobridge::sdpd {
namespace {

MethodParts parts_of(SimulationSettings const& settings) {
  return std::visit([&](auto const& method) { return method.parts(settings); }, settings.method);
}

/// Adds the sums to LAMMPS's forces.
void add_to_forces(RankParticles const& particles, std::vector<Row> const& sums) {
  for (std::size_t i = 0; i < particles.all; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      particles.f[3 * i + c] += sums[i][c];
}

} // namespace

DecomposedFluid::DecomposedFluid(SimulationSettings const& settings)
    : parts_(parts_of(settings)), range_(settings.range()), skin_(skin_of(settings)), dt_(settings.dt),
      box_edge_(box_of(settings).edge), fluctuate_every_(settings.scheme.verlet_steps), seed_(settings.seed) {
  if (auto const in_turn = scheme_in_turn(settings.scheme.pairs))
    scheme_ = *in_turn, blocks_.emplace(box_of(settings), range_);
}

void DecomposedFluid::kick(RankParticles const& particles) const {
  for (std::size_t k = 0; k < 3 * particles.owned; ++k)
    particles.v[k] += particles.f[k] * (dt_ / 2);
}

void DecomposedFluid::kick_and_drift(RankParticles const& particles, double* q) const {
  kick(particles);
  for (std::size_t k = 0; k < 3 * particles.owned; ++k)
    q[k] += particles.v[k] * dt_;
}

void DecomposedFluid::stop_at(Failure const& failure, std::uint64_t step) const {
  if (failure.any())
    throw PhysicsError(fmt::format("particle {} at step {} (dt = {:.6g} reduced): {}", failure.id(), step,
                                   dt_, failure.message()));
}

void DecomposedFluid::add_forces(RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step) {
  rows_.resize(particles.all);
  for (std::size_t i = 0; i < particles.all; ++i)
    rows_[i] = Row{particles.q[3 * i], particles.q[3 * i + 1], particles.q[3 * i + 2], 0};
  pairs_.find(particles, rows_, range_);
  if (has_energies())
    take_in(particles, step);
  if (has_densities()) {
    find_densities(particles, ghosts);
    renew_thermodynamics(particles.owned, given_, step);
    given_ = Given::entropies;
    add_pressure_forces(particles, ghosts);
  } else {
    Failure failure;
    add_pair_forces(particles, failure);
    stop_at(failure, step);
  }
  add_to_forces(particles, sums_);
}

/// Of the pair potential.
void DecomposedFluid::add_pair_forces(RankParticles const& particles, Failure& failure) {
  sums_.assign(particles.all, Row{});
  std::visit(
      [&]<class Potential>(Potential const& potential) {
        if constexpr (!std::is_same_v<Potential, NoPotential>)
          for_each_eight(pairs_, rows_, [&](EightPairs const& at) {
            unsigned const present = (1u << at.count) - 1;
            for (unsigned near = less(at.r, broadcast(potential.inner())) & present; near != 0;
                 near &= near - 1) {
              auto const l = static_cast<std::size_t>(std::countr_zero(near));
              report_too_near(failure, particles.id(at.i[l]), particles.id(at.j[l]), at.r[l],
                              potential.inner());
            }
            Lanes const zero{}, s = potential(at.r, at.inverse_r).strength;
            Lanes const strength = at.r < broadcast(potential.cutoff()) ? s : zero;
            add_opposite(sums_, at, strength * at.x, strength * at.y, strength * at.z);
          });
      },
      parts_.potential);
}

/// Of the own particles, by all that is in their range (sdpd/README.md, Eq. (S5)).
void DecomposedFluid::find_densities(RankParticles const& particles, GhostExchange& ghosts) {
  rho_.assign(particles.all, 0);
  std::visit(
      [&](auto const& kernel) {
        for_each_eight(pairs_, rows_, [&](EightPairs const& at) { add_to_both(rho_, at, kernel.W(at.r)); });
      },
      parts_.kernel);
  ghosts.reverse({rho_.data(), 1, 1});
  for (std::size_t i = 0; i < particles.owned; ++i)
    own_.rho[i] = parts_.self_density + rho_[i];
}

void DecomposedFluid::add_pressure_forces(RankParticles const& particles, GhostExchange& ghosts) {
  for (std::size_t i = 0; i < particles.owned; ++i)
    rows_[i][3] = own_.P[i] / (own_.rho[i] * own_.rho[i]);
  constexpr int pressure = 3;
  ghosts.forward({reinterpret_cast<double*>(rows_.data()) + pressure, 4, 1});
  sums_.assign(particles.all, Row{});
  std::visit(
      [&](auto const& kernel) {
        for_each_eight(pairs_, rows_, [&](EightPairs const& at) {
          Lanes const strength = (at.of_i + at.of_j) * kernel.F(at.r, at.inverse_r);
          add_opposite(sums_, at, strength * at.x, strength * at.y, strength * at.z);
        });
      },
      parts_.kernel);
}

/// The own particles as the thermodynamics want them.
void DecomposedFluid::take_in(RankParticles const& particles, std::uint64_t step) {
  std::size_t const n = particles.owned;
  own_.resize(n, {.energies = true, .densities = has_densities()});
  for (std::size_t i = 0; i < n; ++i) {
    own_.id[i] = particles.id(i), own_.eps[i] = carried[i].eps, own_.T[i] = carried[i].T;
    if (has_densities())
      own_.S[i] = carried[i].S;
  }
  if (has_densities())
    return;
  Failure failure; // their temperatures do not depend on their places
  parts_.thermodynamics->response(own_, {0, n}, failure);
  stop_at(failure, step);
}

void DecomposedFluid::renew_thermodynamics(std::size_t owned, Given given, std::uint64_t step) {
  Failure failure;
  if (given == Given::entropies)
    parts_.thermodynamics->from_entropy(own_, {0, owned}, failure);
  else
    parts_.thermodynamics->from_energy(own_, {0, owned}, failure);
  stop_at(failure, step);
  for (std::size_t i = 0; i < owned; ++i)
    carried[i] = {own_.eps[i], own_.T[i], has_densities() ? own_.S[i] : 0};
}

} // namespace mesobridge::sdpd
