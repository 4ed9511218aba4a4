#include "sdpd/fluctuation/exact_heat.hpp"
#include "sdpd/fluctuation/exact_step.hpp"

namespace mesobridge::sdpd {
namespace {

template <class Law>
HeatStep<double> step_of(Sweep<Law> const& sweep, double weight, PairStates::States const& at) {
  return sweep.law.step(weight, sweep.dt, {at[0].T, at[1].T, at[0].inverse_C, at[1].inverse_C},
                        at[0].T - at[1].T);
}

} // namespace

template <class Law>
void ExactHeat<Law>::step(PairScheme scheme, double weight, Noise const& noise, Sweep<Law> const& sweep,
                          PairCounts& counts) {
  auto const there = step_of(sweep, weight, pair_.now());
  double const heat = there.mean + std::sqrt(there.variance) * noise.G;
  if (makes_step(scheme, pair_, {heat, -heat}, noise.uniform, counts, [&](auto const& proposed) {
        return log_acceptance(weight, noise.G, heat, sweep, proposed);
      }))
    pair_[0].u += heat, pair_[1].u -= heat;
}

/// The ratio of the densities of the step back and forth times that of the invariant measure (see conduct).
template <class Law>
double ExactHeat<Law>::log_acceptance(double weight, double G, double heat, Sweep<Law> const& sweep,
                                      PairStates::States const& proposed) const {
  auto const there = step_of(sweep, weight, pair_.now()), back = step_of(sweep, weight, proposed);
  double a = 0;
  if (back.variance > 0) { // else the pair is out of range and nothing happens
    double const rest = heat + back.mean;
    a = 0.5 * (G * G - rest * rest / back.variance + std::log(there.variance / back.variance));
  }
  return a + log_measure_change<Law>(pair_.now(), proposed, sweep.law.boltzmann);
}

template class ExactHeat<SdpdConduction>;
template class ExactHeat<DpdeConduction>;

} // namespace mesobridge::sdpd
