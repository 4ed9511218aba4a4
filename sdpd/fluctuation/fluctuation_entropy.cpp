#include "sdpd/fluctuation/fluctuation_entropy.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"
#include "sdpd/fluctuation/sweep.hpp"

namespace mesobridge::sdpd {
namespace {

/// Momentum that a pair gives to its first particle and takes from its second, entropy that both gain.
struct PairStep {
  Vec3 dp;
  double dS_i, dS_j;
};

/// What a particle gains from all its pairs.
struct Gain {
  Vec3 dp{};
  double dS = 0;
};

struct PairGeometry {
  Vec3 e;
  double chi;
  Vec3 diagonal, off; ///< of the noise
};

PairStep step_of(SdpdLaw const& law, double dt, VelocityScale<double> const& scale,
                 FluctuatingParticle const& i, FluctuatingParticle const& j, PairGeometry const& pair) {
  double const T_i = i.caloric.T_0, T_j = j.caloric.T_0, k_B = law.boltzmann;
  double const tau = T_i * T_j / (T_i + T_j);
  double const share_i = k_B * i.caloric.inverse_C_0, share_j = k_B * j.caloric.inverse_C_0;
  double const d = tau / (T_i + T_j) * (share_i + share_j);
  double const a = law.friction.perp(pair.chi), b = law.friction.par(pair.chi) - 4 * a / 3;
  Vec3 const v = scale.velocity(i.p, j.p);
  double const ev = dot(pair.e, v);
  Vec3 const noise = std::sqrt(dt) * matrix_noise(std::sqrt(8 * k_B * a * tau), std::sqrt(12 * k_B * b * tau),
                                                  pair.e, pair.diagonal, pair.off);
  double const dissipated = a * norm2(v) + (a / 3 + b) * ev * ev;
  double const common = -2 * k_B * tau * (10 * a / 3 + b) * dt - 0.5 * dot(v, noise);
  auto entropy = [&](double T, double share, double T_other) {
    return (0.5 * (1 - d - share * T_other / (T_i + T_j)) * dissipated * dt + common) / T;
  };
  Vec3 const change = -(1 - d) * dt * (a * v + (a / 3 + b) * ev * pair.e) + noise;
  return {scale.momentum(change), entropy(T_i, share_i, T_j), entropy(T_j, share_j, T_i)};
}

void add_steps(System& system, SdpdLaw const& law, double dt, bool second, std::size_t number,
               std::vector<double>& entropy_gain) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs diagonal, off;
  auto const pairs = system.neighbours.pairs(number);
  block.copy_in(system, number);
  prepare_pairs(system, law, block, pairs, SweepNoise::of_fluctuation(system, second).pairs, diagonal);
  prepare_pairs(system, law, block, pairs,
                NoiseSource(system.seed, off_diagonal_noise.of(second), system.step), off);
  thread_local std::vector<Gain> sums;
  sums.assign(block.size(), {});
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    auto const [i, j] = pairs[k];
    double const sign = block.ids()[i] < block.ids()[j] ? 1 : -1; // undoes that of prepare_pairs
    VelocityScale<double> const scale(block.masses_of_pair(pairs[k]));
    auto const step = step_of(law, dt, scale, block.particles()[i], block.particles()[j],
                              {.e = {diagonal.e_x[k], diagonal.e_y[k], diagonal.e_z[k]},
                               .chi = diagonal.weight[k],
                               .diagonal = sign * Vec3{diagonal.G_x[k], diagonal.G_y[k], diagonal.G_z[k]},
                               .off = sign * Vec3{off.G_x[k], off.G_y[k], off.G_z[k]}});
    sums[i].dp += step.dp, sums[j].dp -= step.dp;
    sums[i].dS += step.dS_i, sums[j].dS += step.dS_j;
  }
  for_each_member(block.members(), [&](std::size_t local, Index i, Vec3 const&) {
    system.impulse[i] += sums[local].dp;
    entropy_gain[i] += sums[local].dS;
  });
}

} // namespace

Vec3 matrix_noise(double A, double B, Vec3 const& e, Vec3 const& diagonal, Vec3 const& off) {
  double const trace = diagonal.x + diagonal.y + diagonal.z, half = std::sqrt(0.5);
  Vec3 const symmetric{diagonal.x * e.x + half * (off.z * e.y + off.y * e.z),
                       diagonal.y * e.y + half * (off.z * e.x + off.x * e.z),
                       diagonal.z * e.z + half * (off.y * e.x + off.x * e.y)};
  return A * (symmetric - trace / 3 * e) + B / 3 * trace * e;
}

void fluctuate_entropies(System& system, double dt, bool second) {
  auto const* const law = std::get_if<SdpdLaw>(&system.law);
  if (!law)
    throw InputError("scheme entropy: is the original form of SDPD and serves no other method");
  auto& particles = system.particles;
  system.impulse.assign(system.size(), {});
  system.energy_gain.assign(system.size(), 0);
  std::vector<double> entropy_gain(system.size());
  for_each_block(system.neighbours.grid(), system.threads,
                 [&](std::size_t block) { add_steps(system, *law, dt, second, block, entropy_gain); });
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
      particles.p[i] += system.impulse[i], particles.S[i] += entropy_gain[i];
  });
  thermodynamics_from_entropy(system);
}

PairIntegrator entropy_integrator() {
  return {.name = "entropy",
          .summary = "the original form of SDPD, which heats unless steps are tiny",
          .sweep = fluctuate_entropies,
          .conserves = {Conserved::positions, Conserved::momentum},
          .noise = {fluctuation_noise, off_diagonal_noise},
          .short_steps_only = true,
          .needs = {.densities = "it is the original form of SDPD and serves no other method"}};
}

} // namespace mesobridge::sdpd
