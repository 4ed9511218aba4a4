#pragma once
#include "sdpd/system.hpp"
#include <algorithm>
#include <array>
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

/// Picks the pairs in range from the candidates of one cell pair, with their separations and, for the while,
/// |r|^2 in the place of F. Returns how many there are.
inline std::size_t select_pairs(std::span<Vec3 const> q, Neighbours& neighbours, std::size_t task,
                                double range2) {
  auto const room = neighbours.room(task);
  Vec3 const shift = neighbours.shift(task);
  std::size_t count = 0;
  for (auto const [i, j] :
       neighbours.candidates(task)) { // without a branch: what is out of range is overwritten by the next
    Vec3 const r = q[i] - q[j] - shift;
    double const r2 = norm2(r);
    room.i[count] = i, room.j[count] = j;
    room.x[count] = r.x, room.y[count] = r.y, room.z[count] = r.z, room.F[count] = r2;
    count += r2 < range2;
  }
  return count;
}

/// F of the pairs from their |r|^2, and what they add to the densities.
template <class Kernel>
void add_densities(Kernel const& kernel, Pairs const& pairs, std::vector<double>& rho) {
  constexpr std::size_t block = 64; // small enough for the first cache
  std::array<double, block> W;
  for (std::size_t begin = 0; begin < pairs.size(); begin += block) {
    std::size_t const count = std::min(block, pairs.size() - begin);
    double* const F = pairs.F.data() + begin;
    for (std::size_t k = 0; k < count; ++k) {
      double const r = std::sqrt(F[k]);
      W[k] = kernel.W(r);
      F[k] = kernel.F(r);
    }
    for (std::size_t k = 0; k < count; ++k) {
      rho[pairs.i[begin + k]] += W[k];
      rho[pairs.j[begin + k]] += W[k];
    }
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
    std::size_t const count = select_pairs(particles.q, neighbours, task, range2);
    neighbours.set_pair_count(task, count);
    add_densities(system.kernel, neighbours.pairs(task), particles.rho);
  });
}

inline void set_entropy_and_pressure(Particles& particles, std::size_t i, auto const& at_density, double T) {
  particles.T[i] = T;
  particles.S[i] = at_density.entropy(T);
  particles.P[i] = at_density.pressure(T);
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
    particles.caloric[i] = at.caloric(T);
  });
}

/// S and P of every particle from its temperature and its density, energies untouched: what a restart needs
/// to find the very numbers that the stopped run held.
template <class S>
void thermodynamics_from_temperature(S& system) {
  auto& particles = system.particles;
  for_each_particle(system, [&](std::size_t i) {
    set_entropy_and_pressure(particles, i, system.eos.at(particles.rho[i]), particles.T[i]);
  });
}

/// T, S and P of every particle from its internal energy and its density.
template <class S>
void thermodynamics_from_energy(S& system) {
  auto& particles = system.particles;
  for_each_particle(system, [&](std::size_t i) {
    auto const at = system.eos.at(particles.rho[i]);
    set_entropy_and_pressure(particles, i, at, at.temperature_from_energy(particles.eps[i], particles.T[i]));
  });
}

/// Conservative forces f_i = sum_j m_i m_j (P_i/rho_i^2 + P_j/rho_j^2) F_ij r_ij (Eq. 1.28) and their virial.
template <class S>
void find_forces(S& system) {
  auto& particles = system.particles;
  auto& neighbours = system.neighbours;
  auto& pushed = system.scratch.pushed;
  auto& virial = system.scratch.virial;
  pushed.resize(particles.size()), virial.resize(neighbours.grid().pairs().size());
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < particles.size(); ++i)
    pushed[i] = {{}, particles.P[i] / (particles.rho[i] * particles.rho[i])};
  for_each_task(neighbours.grid(), system.threads, [&](std::size_t task) {
    double sum = 0;
    auto const pairs = neighbours.pairs(task);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      PushedParticle &a = pushed[pairs.i[k]], &b = pushed[pairs.j[k]];
      Vec3 const r = pairs.r(k), f = (a.push + b.push) * pairs.F[k] * r;
      a.f += f, b.f -= f;
      sum += dot(f, r);
    }
    virial[task] = sum;
  });
  system.virial = std::accumulate(virial.begin(), virial.end(), 0.0);
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.f[i] = pushed[i].f;
}

} // namespace mesobridge::sdpd
