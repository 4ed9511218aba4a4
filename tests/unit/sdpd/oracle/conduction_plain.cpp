#include "sdpd/fluctuation/conduction.hpp"
#include "sdpd/fluctuation/exact_heat.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/state/pair_counts.hpp"
#include "unit/sdpd/oracle/plain.hpp"
#include "unit/sdpd/oracle/plain_sweep.hpp"

namespace mesobridge::sdpd {
namespace {

template <class Law, class Weights>
void sweep_block(System& system, Weights const& weights, PairScheme scheme, std::size_t number,
                 Sweep<Law> const& sweep, PairCounts& counts, Failure& failure) {
  FluctuatingBlock block;
  block.copy_in(system, number);
  auto const& particles = system.particles;
  auto inverse_density = [&](Index k) { return particles.rho.empty() ? 0 : 1 / particles.rho[k]; };
  for (auto const pair : system.neighbours.pairs(number)) {
    Index const i = block.index(pair.i), j = block.index(pair.j);
    double const r = norm(system.box.minimum_image(particles.q[i] - particles.q[j]));
    double const weight = weights(r, 1 / r, inverse_density(i), inverse_density(j)).par;
    auto const [low, high] = std::minmax(block.ids()[pair.i], block.ids()[pair.j]);
    auto const [G, bits] = gaussians_and_bits_reference(sweep.noise.pairs, low, high);
    double const sign = low == block.ids()[pair.i] ? 1 : -1;
    ++counts.proposed;
    if (!tried(low, failure, [&, low = low, high = high, &G = G, bits = bits] {
          ExactHeat<Law>(PairStates(system, {&block.particles()[pair.i], &block.particles()[pair.j]}, {i, j}))
              .step(scheme, weight, {.G = sign * G[0], .uniform = sweep.noise.uniform(low, high, bits)},
                    sweep, counts);
        }))
      return;
  }
  block.copy_out(system);
}

} // namespace

void conduct_plain(System& system, PairScheme scheme, double dt, bool second) {
  std::visit(
      [&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, std::monostate>)
          sweep_plainly(
              system, law, dt, SweepNoise::of_conduction(system, second), system.conduction_counts,
              [&](auto const& weights, auto&... more) { sweep_block(system, weights, scheme, more...); });
      },
      system.conduction);
}

} // namespace mesobridge::sdpd
