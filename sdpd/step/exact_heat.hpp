#pragma once
#include "sdpd/step/sweep.hpp"

namespace mesobridge::sdpd {

/// One pair's conduction in double precision with exact inversions of the equation of state: what the lanes
/// leave over (steps too large for a caloric expansion), and the oracle of the rest.
template <class Law>
class ExactHeat {
 public:
  struct Noise {
    double G;       ///< of the heat from the second particle to the first
    double uniform; ///< in [0, 1)
  };

  /// Two particles and their places in memory. Throws PhysicsError when one has left the equation of state.
  ExactHeat(System const& system, std::array<FluctuatingParticle*, 2> particles, std::array<Index, 2> places);

  /// Makes the step, or not; counts what was not. Throws PhysicsError for SSA when the step leaves the
  /// equation of state. The caloric expansions are left as they are, though they may be out of reach.
  void step(PairScheme scheme, double weight, Noise const& noise, Sweep<Law> const& sweep,
            PairCounts& counts);

 private:
  using States = std::array<ThermalState, 2>;

  ThermalState state(std::size_t k, double heat) const;
  double log_acceptance(double weight, double G, double heat, Sweep<Law> const& sweep,
                        States const& proposed) const;

  System const& system_;
  std::array<FluctuatingParticle*, 2> particles_;
  std::array<Index, 2> index_;
  States at_;
};

} // namespace mesobridge::sdpd
