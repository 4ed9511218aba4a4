#pragma once
#include "sdpd/system.hpp"
#include <algorithm>
#include <numeric>

/// The sub-steps of the conservative dynamics: Velocity Verlet at constant entropies (theory sheet, sections
/// 2, 3).
namespace mesobridge::sdpd {

/// p += f dt. Conserves the momentum, since the forces do.
template <class S>
void kick(S& system, double dt) {
  auto& particles = system.particles;
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.p[i] += particles.f[i] * dt;
}

/// q += p/m dt.
template <class S>
void drift(S& system, double dt) {
  auto& particles = system.particles;
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.q[i] += particles.p[i] * dt;
}

/// Renews the neighbour lists if some particle has come too far.
template <class S>
void refresh_lists(S& system) {
  if (system.neighbours.outdated(system.particles.q)) {
    system.neighbours.renew(system.particles);
    ++system.renewals;
  }
}

/// Picks the pairs in range with their separations and F, and sums rho_i = sum_j m_j W_ij with the self term.
template <class S>
void find_pairs_and_densities(S& system) {
  auto& particles = system.particles;
  auto& neighbours = system.neighbours;
  double const range2 = neighbours.range() * neighbours.range();
  std::fill(particles.rho.begin(), particles.rho.end(), system.self_density());
  for_each_task(neighbours.grid(), system.threads, [&](std::size_t task) {
    auto const candidates = neighbours.candidates(task);
    auto const room = neighbours.room(task);
    Vec3 const shift = neighbours.shift(task);
    std::size_t count = 0;
    for (auto const [i, j] : candidates) { // without a branch: a pair out of range is overwritten by the next
      Vec3 const r = particles.q[i] - particles.q[j] - shift;
      double const r2 = norm2(r);
      room[count] = {i, j, r, r2};
      count += r2 < range2;
    }
    neighbours.set_pair_count(task, count);
    for (auto& pair : room.first(count)) {
      double const r = std::sqrt(pair.F);
      double const W = system.kernel.W(r);
      pair.F = system.kernel.F(r);
      particles.rho[pair.i] += W;
      particles.rho[pair.j] += W;
    }
  });
}

/// T, eps and P of every particle from its entropy and its density.
template <class S>
void thermodynamics_from_entropy(S& system) {
  auto& particles = system.particles;
  for_each_particle(system, [&](std::size_t i) {
    auto const at = system.eos.at(particles.rho[i]);
    double const T = at.temperature_from_entropy(particles.S[i], particles.T[i]);
    particles.T[i] = T;
    particles.eps[i] = at.energy(T);
    particles.P[i] = at.pressure(T);
    particles.caloric[i] = at.caloric(particles.eps[i], T);
  });
}

/// T, S and P of every particle from its internal energy and its density.
template <class S>
void thermodynamics_from_energy(S& system) {
  auto& particles = system.particles;
  for_each_particle(system, [&](std::size_t i) {
    auto const at = system.eos.at(particles.rho[i]);
    double const T = at.temperature_from_energy(particles.eps[i], particles.T[i]);
    particles.T[i] = T;
    particles.S[i] = at.entropy(T);
    particles.P[i] = at.pressure(T);
  });
}

/// S and P of every particle from its temperature and its density, energies untouched: what a restart needs
/// to find the very numbers that the stopped run held.
template <class S>
void thermodynamics_from_temperature(S& system) {
  auto& particles = system.particles;
  for_each_particle(system, [&](std::size_t i) {
    auto const at = system.eos.at(particles.rho[i]);
    particles.S[i] = at.entropy(particles.T[i]);
    particles.P[i] = at.pressure(particles.T[i]);
  });
}

/// Conservative forces f_i = sum_j m_i m_j (P_i/rho_i^2 + P_j/rho_j^2) F_ij r_ij (Eq. 1.28) and their virial.
template <class S>
void find_forces(S& system) {
  auto& particles = system.particles;
  auto& neighbours = system.neighbours;
  std::fill(particles.f.begin(), particles.f.end(), Vec3{});
  auto& push = system.scratch.push;
  auto& virial = system.scratch.virial;
  push.resize(particles.size()), virial.resize(neighbours.grid().pairs().size());
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < particles.size(); ++i)
    push[i] = particles.P[i] / (particles.rho[i] * particles.rho[i]);
  for_each_task(neighbours.grid(), system.threads, [&](std::size_t task) {
    double sum = 0;
    for (auto const& pair : std::as_const(neighbours).pairs(task)) {
      double const strength = (push[pair.i] + push[pair.j]) * pair.F;
      particles.f[pair.i] += strength * pair.r;
      particles.f[pair.j] -= strength * pair.r;
      sum += strength * norm2(pair.r);
    }
    virial[task] = sum;
  });
  system.virial = std::accumulate(virial.begin(), virial.end(), 0.0);
}

} // namespace mesobridge::sdpd
