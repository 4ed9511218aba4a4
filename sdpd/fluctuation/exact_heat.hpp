#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/pair_states.hpp"
#include "sdpd/fluctuation/sweep.hpp"
#include "sdpd/state/pair_counts.hpp"

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

  explicit ExactHeat(PairStates const& pair) : pair_(pair) {}

  /// Makes the step, or not; counts what was not. Throws PhysicsError for SSA when the step leaves the
  /// equation of state. The caloric expansions are left as they are, though they may be out of reach.
  void step(PairScheme scheme, double weight, Noise const& noise, Sweep<Law> const& sweep,
            PairCounts& counts);

 private:
  double log_acceptance(double weight, double G, double heat, Sweep<Law> const& sweep,
                        PairStates::States const& proposed) const;

  PairStates pair_;
};

} // namespace mesobridge::sdpd
