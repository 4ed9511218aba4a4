#include "sdpd/fluctuation/exact_pair.hpp"
#include "sdpd/fluctuation/exact_step.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"

namespace mesobridge::sdpd {
namespace {

template <class Law>
Bath<double>::Directions step_of(Sweep<Law> const& sweep, PairWeights<double> const& weight,
                                 PairStates::States const& at) {
  auto const& law = sweep.law;
  auto const [a_par, a_perp] = law.coefficients(weight);
  return law.template bath<double>({at[0].T, at[1].T, at[0].inverse_C, at[1].inverse_C})
      .step(a_par, a_perp, false, sweep.dt);
}

} // namespace

template <class Law>
void ExactPair<Law>::step(PairScheme scheme, Geometry const& geometry, Noise const& noise,
                          Sweep<Law> const& sweep, PairCounts& counts) {
  auto const [par, perp] = step_of(sweep, geometry.weight, pair_.now());
  auto &a = pair_[0], &b = pair_[1];
  Vec3 const& e = geometry.e;
  VelocityScale<double> const scale(pair_.masses());
  Vec3 const v = scale.velocity(a.p, b.p);
  Vec3 const dv = perp.decay * v + perp.kick() * noise.G +
                  ((par.decay - perp.decay) * dot(e, v) + (par.kick() - perp.kick()) * dot(e, noise.G)) * e;
  double const heat = -0.125 * dot(dv, 2 * v + dv);
  if (!makes_step(scheme, pair_, {heat, heat}, noise.uniform, counts, [&](auto const& proposed) {
        return log_acceptance(geometry, noise, sweep, v, dv, proposed);
      }))
    return;
  Vec3 const dp = scale.momentum(0.5 * dv);
  a.p += dp, b.p -= dp;
  a.u += heat, b.u += heat;
}

/// The exponent a of sdpd/README.md, Eq. (S24): the ratio of the densities of the step back and forth
/// times that of the invariant measure.
template <class Law>
double ExactPair<Law>::log_acceptance(Geometry const& geometry, Noise const& noise, Sweep<Law> const& sweep,
                                      Vec3 const& v, Vec3 const& dv,
                                      PairStates::States const& proposed) const {
  auto const there = step_of(sweep, geometry.weight, pair_.now()),
             back = step_of(sweep, geometry.weight, proposed);
  // What the noise of the step back would have to be, times B': v - A'v' without cancellation.
  Vec3 const moved = v + dv;
  Vec3 const rest = -(dv + back.perp.decay * moved);
  double const along = -(dot(geometry.e, dv) + back.par.decay * dot(geometry.e, moved));
  double a = 0;
  if constexpr (Law::across == Transverse::common) {
    double const across2 = norm2(rest) - dot(geometry.e, rest) * dot(geometry.e, rest);
    a = 0.5 * norm2(noise.G) - 0.5 * (along * along / back.par.variance + across2 / back.perp.variance) +
        0.5 * std::log(there.par.variance / back.par.variance) +
        std::log(there.perp.variance / back.perp.variance);
  } else { // either friction may vanish alone: then nothing happens in its direction
    double const noise_along = dot(geometry.e, noise.G);
    if (back.par.variance > 0)
      a += 0.5 * (noise_along * noise_along - along * along / back.par.variance +
                  std::log(there.par.variance / back.par.variance));
    if (back.perp.variance > 0)
      a += 0.5 * (norm2(noise.G - noise_along * geometry.e) -
                  norm2(rest - dot(geometry.e, rest) * geometry.e) / back.perp.variance) +
           std::log(there.perp.variance / back.perp.variance);
  }
  return a + log_measure_change<Law>(pair_.now(), proposed, boltzmann_);
}

template class ExactPair<SdpdLaw>;
template class ExactPair<DpdeLaw<Transverse::none>>;
template class ExactPair<DpdeLaw<Transverse::own>>;

} // namespace mesobridge::sdpd
