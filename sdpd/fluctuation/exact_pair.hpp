#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/pair_states.hpp"
#include "sdpd/fluctuation/sweep.hpp"
#include "sdpd/state/pair_counts.hpp"

namespace mesobridge::sdpd {

/// One pair's step in double precision with exact inversions of the equation of state: what the lanes leave
/// over (steps too large for a caloric expansion), and the oracle of the rest. For laws with energies.
template <class Law>
class ExactPair {
 public:
  struct Geometry {
    Vec3 e; ///< direction
    PairWeights<double> weight;
  };
  struct Noise {
    Vec3 G;
    double uniform; ///< in [0, 1)
  };

  /// `boltzmann` is that of the invariant measure.
  ExactPair(PairStates const& pair, double boltzmann) : pair_(pair), boltzmann_(boltzmann) {}

  /// Makes the step, or not; counts what was not. Throws PhysicsError for SSA when the step leaves the
  /// equation of state. The caloric expansions are left as they are, though they may be out of reach.
  void step(PairScheme scheme, Geometry const& geometry, Noise const& noise, Sweep<Law> const& sweep,
            PairCounts& counts);

 private:
  double log_acceptance(Geometry const& geometry, Noise const& noise, Sweep<Law> const& sweep, Vec3 const& v,
                        Vec3 const& dv, PairStates::States const& proposed) const;

  PairStates pair_;
  double boltzmann_;
};

} // namespace mesobridge::sdpd
