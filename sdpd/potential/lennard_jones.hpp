#pragma once
#include "sdpd/potential/kind.hpp"
#include "sdpd/potential/pair_force.hpp"

namespace mesobridge::sdpd {

/// 4 epsilon [(sigma/r)^12 - (sigma/r)^6], cut at r_c and shifted to zero there.
class LennardJones {
 public:
  static constexpr Parameter zero{"sigma", Dimension::length, "where it is zero", positive};

  LennardJones(double epsilon, double sigma, double cutoff)
      : epsilon_(epsilon), sigma_(sigma), cutoff_(cutoff) {
    potential_depth.check("Lennard-Jones", epsilon);
    zero.check("Lennard-Jones", sigma);
    potential_end.check("Lennard-Jones", cutoff);
    shift_ = (*this)(cutoff, 1 / cutoff).energy;
  }
  /// Weeks, Chandler and Andersen's: cut at its minimum, so that it only repels.
  static LennardJones wca(double epsilon, double sigma) {
    return {epsilon, sigma, std::pow(2.0, 1.0 / 6) * sigma};
  }
  static std::vector<PotentialKind<LennardJones>> kinds() {
    return {{"lj",
             "cut and shifted",
             {potential_depth, zero, potential_end},
             [](auto x) { return LennardJones(x[0], x[1], x[2]); }},
            {"wca", "", {potential_depth, zero}, [](auto x) { return wca(x[0], x[1]); }}};
  }
  LennardJones in_units(double length, double energy) const {
    return {epsilon_ / energy, sigma_ / length, cutoff_ / length};
  }
  double cutoff() const { return cutoff_; }
  static constexpr double inner() { return 0; }

  /// Valid for 0 < r <= r_c.
  template <class X>
  PairForce<X> operator()(X const&, X const& inverse_r) const {
    X const s = sigma_ * inverse_r, s2 = s * s, s6 = s2 * s2 * s2;
    return {4 * epsilon_ * (s6 * (s6 - 1.0)) - shift_,
            24 * epsilon_ * (s6 * (2.0 * s6 - 1.0)) * (inverse_r * inverse_r)};
  }

 private:
  double epsilon_, sigma_, cutoff_, shift_ = 0;
};

} // namespace mesobridge::sdpd
