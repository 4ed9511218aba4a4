#include "sdpd/fluctuation/conduction.hpp"
#include "sdpd/fluctuation/exact_heat.hpp"
#include "sdpd/fluctuation/heat_strip.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/pair_sweep.hpp"
#include "sdpd/state/pair_counts.hpp"

namespace mesobridge::sdpd {
namespace {

/// Pairs exchange heat.
struct Conduction {
  template <class Particles>
  using Strip = HeatStrip<Particles>;
  static constexpr bool expands_present_state = false;

  template <class Law>
  static void exact_step(PairScheme scheme, LeftPair const& pair, Sweep<Law> const& sweep,
                         PairCounts& counts) {
    ExactHeat<Law>(pair.states)
        .step(scheme, pair.inputs.weight[pair.k], {.G = pair.inputs.G_x[pair.k], .uniform = pair.uniform},
              sweep, counts);
  }
};

} // namespace

void conduct(System& system, PairScheme scheme, double dt, bool second) {
  std::visit(
      [&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, std::monostate>)
          sweep_pairs<Conduction>(system, scheme,
                                  Sweep<Law>{law, dt, SweepNoise::of_conduction(system, second)},
                                  system.conduction_counts);
      },
      system.conduction);
}

} // namespace mesobridge::sdpd
