#pragma once
#include "sdpd/potential/kind.hpp"
#include "sdpd/potential/pair_force.hpp"
#include "sdpd/simd/lane_math.hpp"

namespace mesobridge::sdpd {

/// Morse's potential, epsilon [(1 - x)^2 - 1] with x = exp(-alpha (r - r_m)) and its minimum -epsilon at r_m
/// (P. M. Morse, Phys. Rev. 34 (1929) 57), cut at r_c and shifted to zero there.
class Morse {
 public:
  static constexpr Parameter width{"width", Dimension::length, "1/alpha, over which the well rises again",
                                   positive};

  Morse(double epsilon, double r_m, double width_of_well, double cutoff)
      : epsilon_(epsilon), r_m_(r_m), width_(width_of_well), cutoff_(cutoff) {
    potential_depth.check("Morse", epsilon);
    potential_minimum.check("Morse", r_m);
    width.check("Morse", width_of_well);
    potential_end.check("Morse", cutoff);
    shift_ = (*this)(cutoff, 1 / cutoff).energy;
  }
  static std::vector<PotentialKind<Morse>> kinds() {
    return {
        {"morse", "cut and shifted", {potential_depth, potential_minimum, width, potential_end}, [](auto x) {
           return Morse(x[0], x[1], x[2], x[3]);
         }}};
  }
  Morse in_units(double length, double energy) const {
    return {epsilon_ / energy, r_m_ / length, width_ / length, cutoff_ / length};
  }
  double cutoff() const { return cutoff_; }
  static constexpr double inner() { return 0; }

  /// Valid for 0 < r <= r_c.
  template <class X>
  PairForce<X> operator()(X const& r, X const& inverse_r) const {
    X const x = exponential((r_m_ - r) * (1 / width_));
    return {epsilon_ * (x * (x - 2.0)) - shift_, (2 * epsilon_ / width_) * (x * (x - 1.0)) * inverse_r};
  }

 private:
  double epsilon_, r_m_, width_, cutoff_, shift_ = 0;
};

} // namespace mesobridge::sdpd
