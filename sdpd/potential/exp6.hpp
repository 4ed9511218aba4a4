#pragma once
#include "sdpd/potential/kind.hpp"
#include "sdpd/potential/pair_force.hpp"
#include "sdpd/simd/lane_math.hpp"

namespace mesobridge::sdpd {

/// Buckingham's exponential-6 potential, epsilon/(alpha - 6) [6 exp(alpha (1 - r/r_m)) - alpha (r_m/r)^6]
/// with its minimum -epsilon at r_m, cut at r_c and shifted to zero there. Inside the distance of its maximum
/// it falls without bound: pairs nearer than inner() are outside the model.
class Exp6 {
 public:
  static constexpr Parameter steepness{
      "alpha", std::nullopt, "steepness; up to 7 there is no minimum", {.min = 7, .open = true, .max = 100}};

  Exp6(double epsilon, double r_m, double alpha, double cutoff);
  static std::vector<PotentialKind<Exp6>> kinds() {
    return {{"exp-6",
             "Buckingham's, which refuses pairs inside its maximum",
             {potential_depth, potential_minimum, steepness, potential_end},
             [](auto x) { return Exp6(x[0], x[1], x[2], x[3]); }}};
  }
  Exp6 in_units(double length, double energy) const {
    return {epsilon_ / energy, r_m_ / length, alpha_, cutoff_ / length};
  }
  double cutoff() const { return cutoff_; }
  double inner() const { return inner_; } ///< where the potential has its maximum

  /// Valid for inner() <= r <= r_c.
  template <class X>
  PairForce<X> operator()(X const& r, X const& inverse_r) const {
    X const s = r_m_ * inverse_r, s2 = s * s, s6 = s2 * s2 * s2;
    X const repulsion = exponential(alpha_ - r * (alpha_ / r_m_));
    return {scale_ * (6.0 * repulsion - alpha_ * s6) - shift_,
            (6 * alpha_ * scale_) * ((repulsion * (1 / r_m_) - s6 * inverse_r) * inverse_r)};
  }

 private:
  double epsilon_, r_m_, alpha_, cutoff_, scale_, inner_, shift_ = 0;
};

} // namespace mesobridge::sdpd
