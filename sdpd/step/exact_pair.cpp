#include "sdpd/step/exact_pair.hpp"

namespace mesobridge::sdpd {
namespace {

using Bath = PairBath<double>;

Bath bath_of(Sweep const& sweep, std::array<ThermalState, 2> const& at) {
  return {sweep.boltzmann, at[0].T, at[1].T, at[0].inverse_C, at[1].inverse_C};
}

Bath::Directions step_of(Sweep const& sweep, double chi, std::array<ThermalState, 2> const& at) {
  return bath_of(sweep, at).step(sweep.friction.par(chi), sweep.friction.perp(chi), false, sweep.dt);
}

} // namespace

double acceptance_uniform(NoiseSource const& source, std::uint32_t low, std::uint32_t high,
                          std::uint32_t first_bits) {
  auto const word =
      Philox4x32::generate({low, high, source.step_low, source.step_high_and_stream}, source.key);
  return (first_bits + word[0] / 4294967296.0) / (1u << spare_bits);
}

ExactPair::ExactPair(System const& system, FluctuatingBlock& block, LocalPair pair)
    : system_(system), particles_{&block.particles()[pair.i], &block.particles()[pair.j]},
      index_{block.index(pair.i), block.index(pair.j)} {
  at_ = {state(0, 0), state(1, 0)};
}

ThermalState ExactPair::state(std::size_t k, double heat) const {
  auto const& of = system_.particles;
  Index const i = index_[k];
  return system_.thermodynamics->state(of.eps[i] + particles_[k]->u + heat, of.rho[i], of.T[i]);
}

void ExactPair::step(PairScheme scheme, Geometry const& geometry, Noise const& noise, Sweep const& sweep,
                     PairCounts& counts) {
  auto const [par, perp] = step_of(sweep, geometry.chi, at_);
  auto& [a, b] = particles_;
  Vec3 const& e = geometry.e;
  Vec3 const v = a->p - b->p;
  Vec3 const dv = perp.decay * v + perp.kick() * noise.G +
                  ((par.decay - perp.decay) * dot(e, v) + (par.kick() - perp.kick()) * dot(e, noise.G)) * e;
  double const heat = -0.125 * dot(dv, 2 * v + dv);
  std::array<ThermalState, 2> proposed;
  try {
    proposed = {state(0, heat), state(1, heat)};
  } catch (PhysicsError const&) {
    if (scheme == PairScheme::ssa)
      throw;
    ++counts.out_of_domain;
    return;
  }
  if (scheme == PairScheme::ems &&
      !(noise.uniform < std::exp(log_acceptance(geometry, noise, sweep, v, dv, proposed)))) {
    ++counts.metropolis;
    return;
  }
  a->p += 0.5 * dv, b->p -= 0.5 * dv;
  a->u += heat, b->u += heat;
}

/// The exponent a of theory sheet, section 3, EMS: the ratio of the densities of the step back and forth
/// times that of the invariant measure.
double ExactPair::log_acceptance(Geometry const& geometry, Noise const& noise, Sweep const& sweep,
                                 Vec3 const& v, Vec3 const& dv,
                                 std::array<ThermalState, 2> const& proposed) const {
  auto const there = step_of(sweep, geometry.chi, at_), back = step_of(sweep, geometry.chi, proposed);
  // What the noise of the step back would have to be, times B': v - A'v' without cancellation.
  Vec3 const moved = v + dv;
  Vec3 const rest = -(dv + back.perp.decay * moved);
  double const along = -(dot(geometry.e, dv) + back.par.decay * dot(geometry.e, moved));
  double const across2 = norm2(rest) - dot(geometry.e, rest) * dot(geometry.e, rest);
  double a = 0.5 * norm2(noise.G) - 0.5 * (along * along / back.par.variance + across2 / back.perp.variance) +
             0.5 * std::log(there.par.variance / back.par.variance) +
             std::log(there.perp.variance / back.perp.variance);
  for (std::size_t k = 0; k < 2; ++k)
    a += (proposed[k].S - at_[k].S) / sweep.boltzmann - std::log(proposed[k].T / at_[k].T);
  return a;
}

} // namespace mesobridge::sdpd
