#pragma once
#include "sdpd/potential/kind.hpp"
#include "sdpd/potential/pair_force.hpp"

namespace mesobridge::sdpd {

/// The soft repulsion of Groot and Warren, J. Chem. Phys. 107 (1997) 4423: force a (1 - r/r_c) e, energy
/// (a r_c/2)(1 - r/r_c)^2 up to the cut-off r_c.
class SoftPotential {
 public:
  static constexpr Parameter largest_force{"a", Dimension::force, "largest force", not_negative};

  SoftPotential(double a, double cutoff) : a_(a), cutoff_(cutoff), inverse_cutoff_(1 / cutoff) {
    largest_force.check("soft repulsion", a);
    potential_end.check("soft repulsion", cutoff);
  }
  static std::vector<PotentialKind<SoftPotential>> kinds() {
    return {{"soft", "the force a (1 - r/cutoff)", {largest_force, potential_end}, [](auto x) {
               return SoftPotential(x[0], x[1]);
             }}};
  }
  SoftPotential in_units(double length, double energy) const {
    return {a_ * length / energy, cutoff_ / length};
  }
  double cutoff() const { return cutoff_; }
  static constexpr double inner() { return 0; }

  /// Valid for 0 <= r <= r_c.
  template <class X>
  PairForce<X> operator()(X const& r, X const& inverse_r) const {
    X const left = 1.0 - r * inverse_cutoff_;
    return {(0.5 * a_ * cutoff_) * (left * left), a_ * left * inverse_r};
  }

 private:
  double a_, cutoff_, inverse_cutoff_;
};

} // namespace mesobridge::sdpd
