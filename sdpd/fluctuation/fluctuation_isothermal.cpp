#include "sdpd/fluctuation/fluctuation_isothermal.hpp"
#include "sdpd/fluctuation/isothermal_sweep.hpp"

namespace mesobridge::sdpd {

template <class Law>
void fluctuate_isothermal(System& system, Law const& law, double dt, bool second) {
  sweep_isothermal(
      system, Sweep<Law>{law, dt, SweepNoise::of_fluctuation(system, second)},
      [](auto const& exact, PairGroup const&) [[gnu::always_inline]] -> auto const& { return exact; });
}

template void fluctuate_isothermal(System&, DpdLaw<Transverse::none> const&, double, bool);
template void fluctuate_isothermal(System&, DpdLaw<Transverse::own> const&, double, bool);

} // namespace mesobridge::sdpd
