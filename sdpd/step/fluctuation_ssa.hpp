#pragma once
#include "sdpd/random.hpp"
#include "sdpd/system.hpp"

namespace mesobridge::sdpd {

/// The part of a pair's work that does not depend on the pairs before it, for noise_lanes pairs at once.
struct PairGroup {
  GaussianLanes noise;
  alignas(64) std::array<double, noise_lanes> inverse_r2, chi;
};

/// Noise (turned so that it points from the smaller to the larger id), 1/r^2 and chi of noise_lanes pairs
/// from `begin`.
inline void prepare(Pairs const& pairs, std::size_t begin, NoiseSource const& source,
                    std::span<std::uint32_t const> id, std::span<double const> inverse_rho,
                    PairGroup& group) {
  alignas(64) std::array<std::uint32_t, noise_lanes> low, high;
  alignas(64) std::array<float, noise_lanes> sign;
  for (std::size_t lane = 0; lane < noise_lanes; ++lane) {
    // Lanes past the end repeat the last pair, so that all hold valid numbers.
    std::size_t const k = std::min(begin + lane, pairs.size() - 1);
    Index const i = pairs.i[k], j = pairs.j[k];
    low[lane] = std::min(id[i], id[j]), high[lane] = std::max(id[i], id[j]);
    sign[lane] = id[i] < id[j] ? 1.0f : -1.0f;
    group.inverse_r2[lane] = 1 / norm2(pairs.r(k));
    group.chi[lane] = pairs.F[k] * inverse_rho[i] * inverse_rho[j];
  }
  gaussians(source, low.data(), high.data(), group.noise);
  for (int lane = 0; lane < noise_lanes; ++lane) {
    group.noise.x[lane] *= sign[lane];
    group.noise.y[lane] *= sign[lane];
    group.noise.z[lane] *= sign[lane];
  }
}

/// One pair's exact Ornstein-Uhlenbeck step; the change of kinetic energy goes to the two internal energies
/// in equal parts, so that momentum and energy are conserved to round-off (theory sheet, section 3, SSA;
/// masses are 1).
[[gnu::always_inline]] inline void fluctuate_pair(FluctuatingParticle& a, FluctuatingParticle& b,
                                                  Vec3 const& r, double inverse_r2, double chi, Vec3 const& G,
                                                  SdpdFriction const& friction, double boltzmann, double dt) {
  PairBath const bath(boltzmann, a.caloric.T, b.caloric.T, a.caloric.inverse_C, b.caloric.inverse_C);
  auto const [par, perp] = bath.step(friction.par(chi), friction.perp(chi), friction.par_is_twice_perp(), dt);
  Vec3 const v = a.p - b.p;
  double const along =
      ((par.decay - perp.decay) * dot(r, v) + (par.kick - perp.kick) * dot(r, G)) * inverse_r2;
  Vec3 const dv = perp.decay * v + perp.kick * G + along * r;
  double const heat = -0.125 * dot(dv, 2 * v + dv);
  a.p += 0.5 * dv, b.p -= 0.5 * dv;
  a.eps += heat, b.eps += heat;
  a.caloric.heat(heat), b.caloric.heat(heat);
}

/// Begins a new caloric expansion at the particle's energy. Throws PhysicsError when that has no temperature
/// > 0.
template <class S>
void renew_caloric(S const& system, FluctuatingParticle& particle, double rho) {
  auto const at = system.eos.at(rho);
  double const T = at.temperature_from_energy(particle.eps, particle.caloric.T_start);
  particle.caloric = at.caloric(T);
}

/// The pairs of one cell pair in turn. Reports to `failure` and stops at the first internal energy that
/// leaves the equation of state.
template <class S>
void fluctuate_task(S& system, std::size_t task, NoiseSource const& source, double dt, Failure& failure) {
  auto& work = system.scratch.fluctuating;
  auto const& rho = system.particles.rho;
  auto const pairs = system.neighbours.pairs(task);
  auto renew = [&](Index i) {
    try {
      renew_caloric(system, work[i], rho[i]);
      return true;
    } catch (std::exception const& error) {
      failure.report(task,
                     fmt::format("{}: fluctuation and dissipation (SSA) took its internal energy to {:.6g} "
                                 "(in K k_B T): {}; take a shorter time step or larger particles",
                                 system.where(i), work[i].eps, error.what()));
      return false;
    }
  };
  PairGroup group;
  for (std::size_t begin = 0; begin < pairs.size(); begin += noise_lanes) {
    prepare(pairs, begin, source, system.particles.id, system.scratch.inverse_rho, group);
    std::size_t const count = std::min<std::size_t>(noise_lanes, pairs.size() - begin);
    for (std::size_t lane = 0; lane < count; ++lane) {
      Index const i = pairs.i[begin + lane], j = pairs.j[begin + lane];
      Vec3 const G{group.noise.x[lane], group.noise.y[lane], group.noise.z[lane]};
      fluctuate_pair(work[i], work[j], pairs.r(begin + lane), group.inverse_r2[lane], group.chi[lane], G,
                     system.friction, system.boltzmann, dt);
      bool const i_in_reach = work[i].caloric.in_reach(), j_in_reach = work[j].caloric.in_reach();
      if (i_in_reach && j_in_reach) [[likely]]
        continue;
      if ((!i_in_reach && !renew(i)) || (!j_in_reach && !renew(j)))
        return;
    }
  }
}

/// Fluctuation and dissipation over dt by Shardlow's splitting: the pairs in turn, in the order of the lists.
/// Densities stay fixed. Needs the caloric expansions of thermodynamics_from_entropy; leaves T behind the
/// energies (call thermodynamics_from_energy). Throws PhysicsError when an internal energy leaves the
/// equation of state.
template <class S>
void fluctuate_ssa(S& system, double dt) {
  auto& particles = system.particles;
  auto& work = system.scratch.fluctuating;
  auto& inverse_rho = system.scratch.inverse_rho;
  std::size_t const n = particles.size();
  work.resize(n), inverse_rho.resize(n);
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < n; ++i) {
    work[i] = {particles.p[i], particles.eps[i], particles.caloric[i]};
    inverse_rho[i] = 1 / particles.rho[i];
  }
  NoiseSource const source(system.seed, Stream::fluctuation, system.step);
  Failure failure;
  for_each_task(system.neighbours.grid(), system.threads,
                [&](std::size_t task) { fluctuate_task(system, task, source, dt, failure); });
  failure.throw_if_any();
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < n; ++i) {
    particles.p[i] = work[i].p;
    particles.eps[i] = work[i].eps;
    particles.T[i] = work[i].caloric.T;
  }
}

} // namespace mesobridge::sdpd
