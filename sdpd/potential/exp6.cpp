#include "sdpd/potential/exp6.hpp"
#include "md/error.hpp"

namespace mesobridge::sdpd {
namespace {

/// The maximum of the potential in units of r_m: the smaller root of alpha (1 - x) + 7 ln x = 0, which lies
/// below 7/alpha, where the left side is largest and positive.
double maximum(double alpha) {
  double low = std::exp(-alpha / 7), high = 7 / alpha; // at `low` the left side is -alpha x < 0
  for (int k = 0; k < 100; ++k) {
    double const middle = 0.5 * (low + high);
    (alpha * (1 - middle) + 7 * std::log(middle) > 0 ? high : low) = middle;
  }
  return high;
}

} // namespace

Exp6::Exp6(double epsilon, double r_m, double alpha, double cutoff)
    : epsilon_(epsilon), r_m_(r_m), alpha_(alpha), cutoff_(cutoff), scale_(epsilon / (alpha - 6)) {
  potential_depth.check("exp-6", epsilon);
  potential_minimum.check("exp-6", r_m);
  steepness.check("exp-6", alpha);
  inner_ = r_m * maximum(alpha);
  require(cutoff > inner_ && std::isfinite(cutoff), "exp-6 cutoff", cutoff,
          fmt::format("must be finite and > {:.6g}, where the potential has its maximum", inner_));
  shift_ = (*this)(cutoff, 1 / cutoff).energy;
}

} // namespace mesobridge::sdpd
