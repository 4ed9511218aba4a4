#include "sdpd/observe/gamma_law.hpp"
#include <algorithm>
#include <gsl/gsl_cdf.h>

namespace mesobridge::sdpd {

std::vector<double> gamma_law(double K, cg::Bins const& bins) {
  double const shape = 1.5 * (K - 1);
  std::vector<double> density(bins.count);
  for (std::size_t b = 0; b < bins.count; ++b) {
    double const low = bins.lower + static_cast<double>(b) * bins.width();
    double const below = gsl_cdf_gamma_P(std::max(0.0, low), shape, 1),
                 above = gsl_cdf_gamma_P(std::max(0.0, low + bins.width()), shape, 1);
    density[b] = (above - below) / bins.width();
  }
  return density;
}

} // namespace mesobridge::sdpd
