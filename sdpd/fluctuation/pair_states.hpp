#pragma once
#include "sdpd/fluctuation/fluctuating_block.hpp"

namespace mesobridge::sdpd {

/// Two particles of a block and the states that they have, or would have with more heat, by exact inversions
/// of the equation of state.
class PairStates {
 public:
  using States = std::array<ThermalState, 2>;

  /// The particles and their places in memory, where `all` has their energies at the start of the sweep, and
  /// densities and masses. Throws PhysicsError when one has left the equation of state.
  PairStates(Thermodynamics const& thermodynamics, Particles const& all,
             std::array<FluctuatingParticle*, 2> particles, std::array<Index, 2> places)
      : thermodynamics_(thermodynamics), all_(all), particles_(particles), index_(places), now_(with(0, 0)) {}
  PairStates(System const& system, std::array<FluctuatingParticle*, 2> particles, std::array<Index, 2> places)
      : PairStates(*system.thermodynamics, system.particles, particles, places) {}

  FluctuatingParticle& operator[](std::size_t k) const { return *particles_[k]; }
  States const& now() const { return now_; }
  PairMasses<double> masses() const { return {all_.mass_of(index_[0]), all_.mass_of(index_[1])}; }
  /// Throws PhysicsError when the equation of state has no such states.
  States with(double heat_a, double heat_b) const { return {state(0, heat_a), state(1, heat_b)}; }

 private:
  ThermalState state(std::size_t k, double heat) const {
    Index const i = index_[k];
    return thermodynamics_.state(all_, i, all_.eps[i] + particles_[k]->u + heat);
  }

  Thermodynamics const& thermodynamics_;
  Particles const& all_;
  std::array<FluctuatingParticle*, 2> particles_;
  std::array<Index, 2> index_;
  States now_;
};

/// The change of the logarithm of a law's invariant measure.
template <class Law>
double log_measure_change(PairStates::States const& from, PairStates::States const& to, double boltzmann) {
  double change = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    change += (to[k].S - from[k].S) / boltzmann;
    if constexpr (Law::measure_over_T)
      change -= std::log(to[k].T / from[k].T);
  }
  return change;
}

} // namespace mesobridge::sdpd
