#include "sdpd/step/exact_heat.hpp"

namespace mesobridge::sdpd {
namespace {

template <class Law>
HeatStep<double> step_of(Sweep<Law> const& sweep, double weight, std::array<ThermalState, 2> const& at) {
  return sweep.law.step(weight, sweep.dt, {at[0].T, at[1].T, at[0].inverse_C, at[1].inverse_C},
                        at[0].T - at[1].T);
}

} // namespace

template <class Law>
ExactHeat<Law>::ExactHeat(System const& system, std::array<FluctuatingParticle*, 2> particles,
                          std::array<Index, 2> places)
    : system_(system), particles_(particles), index_(places) {
  at_ = {state(0, 0), state(1, 0)};
}

template <class Law>
ThermalState ExactHeat<Law>::state(std::size_t k, double heat) const {
  auto const& of = system_.particles;
  Index const i = index_[k];
  return system_.thermodynamics->state(of, i, of.eps[i] + particles_[k]->u + heat);
}

template <class Law>
void ExactHeat<Law>::step(PairScheme scheme, double weight, Noise const& noise, Sweep<Law> const& sweep,
                          PairCounts& counts) {
  auto const there = step_of(sweep, weight, at_);
  double const heat = there.mean + std::sqrt(there.variance) * noise.G;
  States proposed;
  try {
    proposed = {state(0, heat), state(1, -heat)};
  } catch (PhysicsError const&) {
    if (scheme == PairScheme::ssa)
      throw;
    ++counts.out_of_domain;
    return;
  }
  if (scheme == PairScheme::ems &&
      !(noise.uniform < std::exp(log_acceptance(weight, noise.G, heat, sweep, proposed)))) {
    ++counts.metropolis;
    return;
  }
  particles_[0]->u += heat, particles_[1]->u -= heat;
}

/// The ratio of the densities of the step back and forth times that of the invariant measure (see conduct).
template <class Law>
double ExactHeat<Law>::log_acceptance(double weight, double G, double heat, Sweep<Law> const& sweep,
                                      States const& proposed) const {
  auto const there = step_of(sweep, weight, at_), back = step_of(sweep, weight, proposed);
  double a = 0;
  if (back.variance > 0) { // else the pair is out of range and nothing happens
    double const rest = heat + back.mean;
    a = 0.5 * (G * G - rest * rest / back.variance + std::log(there.variance / back.variance));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    a += (proposed[k].S - at_[k].S) / sweep.law.boltzmann;
    if constexpr (Law::measure_over_T)
      a -= std::log(proposed[k].T / at_[k].T);
  }
  return a;
}

template class ExactHeat<SdpdConduction>;
template class ExactHeat<DpdeConduction>;

} // namespace mesobridge::sdpd
