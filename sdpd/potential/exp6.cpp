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
  require(epsilon > 0 && std::isfinite(epsilon), "exp-6 epsilon", epsilon, "must be > 0 and finite");
  require(r_m > 0 && std::isfinite(r_m), "exp-6 r_m", r_m, "must be > 0 and finite");
  require(alpha > 7 && alpha <= 100, "exp-6 alpha", alpha,
          "must be > 7, or the potential has no minimum, and <= 100");
  inner_ = r_m * maximum(alpha);
  require(cutoff > inner_ && std::isfinite(cutoff), "exp-6 cutoff", cutoff,
          fmt::format("must be finite and > {:.6g}, where the potential has its maximum", inner_));
  shift_ = (*this)(cutoff, 1 / cutoff).energy;
}

} // namespace mesobridge::sdpd
