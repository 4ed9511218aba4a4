#pragma once
#include "sdpd/fluctuation/fluctuating_block.hpp"
#include "sdpd/thermodynamics/heated_states.hpp"

namespace mesobridge::sdpd {

/// Two particles of a block and the states that they have, or would have with more heat, by exact inversions
/// of the equation of state; or those that they would have by inversions, beside those that they have by
/// their caloric expansions.
class PairStates {
 public:
  using States = std::array<ThermalState, 2>;

  /// The particles and their places in memory, where `all` has their energies at the start of the sweep, and
  /// densities and masses. Throws PhysicsError when one has left the equation of state.
  PairStates(Thermodynamics const& thermodynamics, Particles const& all,
             std::array<FluctuatingParticle*, 2> particles, std::array<Index, 2> places)
      : thermodynamics_(thermodynamics), all_(all), particles_(particles),
        index_(places), now_{inverted(0, 0), inverted(1, 0)} {}
  /// Whose expansions reach their energies, of a model that offers `heated`.
  PairStates(System const& system, HeatedStates const& heated, std::array<FluctuatingParticle*, 2> particles,
             std::array<Index, 2> places)
      : thermodynamics_(*system.thermodynamics), heated_(&heated), all_(system.particles),
        particles_(particles), index_(places), now_{expanded(0), expanded(1)} {}
  PairStates(System const& system, std::array<FluctuatingParticle*, 2> particles, std::array<Index, 2> places)
      : PairStates(*system.thermodynamics, system.particles, particles, places) {}

  FluctuatingParticle& operator[](std::size_t k) const { return *particles_[k]; }
  States const& now() const { return now_; }
  PairMasses<double> masses() const { return {all_.mass_of(index_[0]), all_.mass_of(index_[1])}; }
  /// Entropies count from where those of now() do. Throws PhysicsError when the equation of state has no such
  /// states.
  States with(double heat_a, double heat_b) const {
    if (heated_)
      return {heated(0, heat_a), heated(1, heat_b)};
    return {inverted(0, heat_a), inverted(1, heat_b)};
  }

 private:
  double energy(std::size_t k) const { return all_.eps[index_[k]] + particles_[k]->u; }
  ThermalState inverted(std::size_t k, double heat) const {
    return thermodynamics_.state(all_, index_[k], energy(k) + heat);
  }
  ThermalState expanded(std::size_t k) const {
    auto const& [p, u, caloric] = *particles_[k];
    return {.T = caloric.T(u), .S = 0, .inverse_C = caloric.inverse_C(u)};
  }
  ThermalState heated(std::size_t k, double heat) const {
    auto const& [p, u, caloric] = *particles_[k];
    return heated_->heated(all_, index_[k], {energy(k), now_[k].T}, heat, caloric.T(u + heat));
  }

  Thermodynamics const& thermodynamics_;
  HeatedStates const* heated_ = nullptr;
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
