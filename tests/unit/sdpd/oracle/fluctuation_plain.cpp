#include "sdpd/fluctuation/exact_pair.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/state/pair_counts.hpp"
#include "unit/sdpd/oracle/plain.hpp"
#include "unit/sdpd/oracle/plain_sweep.hpp"

namespace mesobridge::sdpd {
namespace {

/// One pair's step at the set temperature.
template <class Law>
void isothermal_step(Row& a, Row& b, Vec3 const& e, PairWeights<double> const& weight, Vec3 const& G,
                     Sweep<Law> const& sweep) {
  auto const [a_par, a_perp] = sweep.law.coefficients(weight);
  auto const [par, perp] = sweep.law.template bath<double>().step(a_par, a_perp, false, sweep.dt);
  Vec3 const v{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  Vec3 const v_par = dot(e, v) * e, G_par = dot(e, G) * e;
  Vec3 const dp =
      0.5 * (par.decay * v_par + par.kick() * G_par + perp.decay * (v - v_par) + perp.kick() * (G - G_par));
  a += Row{dp.x, dp.y, dp.z, 0}, b -= Row{dp.x, dp.y, dp.z, 0};
}

template <class Law, class Weights>
void sweep_block(System& system, Weights const& weights, PairScheme scheme, std::size_t number,
                 Sweep<Law> const& sweep, PairCounts& counts, Failure& failure) {
  BlockOf<Law> block;
  block.copy_in(system, number);
  for (auto const pair : system.neighbours.pairs(number)) {
    Index const i = block.index(pair.i), j = block.index(pair.j);
    auto const& particles = system.particles;
    Vec3 const r = system.box.minimum_image(particles.q[i] - particles.q[j]), e = r / norm(r);
    auto inverse_density = [&](Index k) { return particles.rho.empty() ? 0 : 1 / particles.rho[k]; };
    auto const low = std::min(block.ids()[pair.i], block.ids()[pair.j]),
               high = std::max(block.ids()[pair.i], block.ids()[pair.j]);
    auto const [g, bits] = gaussians_and_bits_reference(sweep.noise.pairs, low, high);
    Vec3 const G = Law::noise == PairNoise::along
                       ? g[0] * e
                       : (low == block.ids()[pair.i] ? 1.0 : -1.0) * Vec3{g[0], g[1], g[2]};
    PairWeights<double> const weight = weights(norm(r), 1 / norm(r), inverse_density(i), inverse_density(j));
    ++counts.proposed;
    if constexpr (!Law::has_energies) {
      isothermal_step(block.particles()[pair.i], block.particles()[pair.j], e, weight, G, sweep);
    } else {
      double const uniform = sweep.noise.uniform(low, high, bits);
      if (!tried(low, failure, [&] {
            ExactPair<Law>(
                PairStates(system, {&block.particles()[pair.i], &block.particles()[pair.j]}, {i, j}),
                system.boltzmann)
                .step(scheme, {.e = e, .weight = weight}, {.G = G, .uniform = uniform}, sweep, counts);
          }))
        return;
    }
  }
  block.copy_out(system);
}

} // namespace

void fluctuate_plain(System& system, PairScheme scheme, double dt, bool second) {
  std::visit(
      [&]<class Law>(Law const& law) {
        sweep_plainly(
            system, law, dt, SweepNoise::of_fluctuation(system, second), system.pair_counts,
            [&](auto const& weights, auto&... more) { sweep_block(system, weights, scheme, more...); });
      },
      system.law);
}

} // namespace mesobridge::sdpd
