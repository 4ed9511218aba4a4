#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/exact_pair.hpp"
#include "sdpd/fluctuation/fluctuation_isothermal.hpp"
#include "sdpd/fluctuation/fluctuation_strip.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/pair_sweep.hpp"
#include "sdpd/state/pair_counts.hpp"

namespace mesobridge::sdpd {
namespace {

/// Pairs exchange momentum, and what that leaves of their kinetic energy becomes heat.
struct Friction {
  template <class Particles>
  using Strip = FluctuationStrip<Particles>;
  static constexpr bool expands_present_state = true;

  template <class Law>
  static void exact_step(PairScheme scheme, LeftPair const& pair, Sweep<Law> const& sweep,
                         PairCounts& counts) {
    auto const& [inputs, k] = std::tie(pair.inputs, pair.k);
    Vec3 const e{inputs.e_x[k], inputs.e_y[k], inputs.e_z[k]};
    double const par = inputs.weight[k];
    double perp = Law::across == Transverse::none ? 0 : par;
    if constexpr (Law::across == Transverse::own)
      perp = inputs.weight_across[k];
    ExactPair<Law>(pair.states, pair.boltzmann)
        .step(scheme, {.e = e, .weight = {par, perp}},
              {.G = noise<Law>(inputs, k, e), .uniform = pair.uniform}, sweep, counts);
  }

 private:
  template <class Law>
  static Vec3 noise(PairInputs const& inputs, std::size_t k, Vec3 const& e) {
    if constexpr (Law::noise == PairNoise::along)
      return double{inputs.G_x[k]} * e;
    else
      return {inputs.G_x[k], inputs.G_y[k], inputs.G_z[k]};
  }
};

template <class Law>
void fluctuate(System& system, Law const& law, PairScheme scheme, double dt, bool second) {
  if constexpr (Law::has_energies)
    sweep_pairs<Friction>(system, scheme, Sweep<Law>{law, dt, SweepNoise::of_fluctuation(system, second)},
                          system.pair_counts);
  else
    fluctuate_isothermal(system, law, dt, second);
}

} // namespace

void fluctuate(System& system, PairScheme scheme, double dt, bool second) {
  std::visit([&](auto const& law) { fluctuate(system, law, scheme, dt, second); }, system.law);
}

} // namespace mesobridge::sdpd
