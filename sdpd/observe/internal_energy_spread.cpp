#include "sdpd/observe/measurement.hpp"
#include "sdpd/system/system.hpp"
#include <cmath>

namespace mesobridge::sdpd {
namespace {

/// (sum (eps - mean)^2/(N-1))^(1/2), freed from its bias of -1/4(N-1), which is that of Gaussian numbers.
std::vector<double> spread(System const& system) {
  double const N = static_cast<double>(system.size());
  double sum = 0, squares = 0;
  for (double const eps : system.particles.eps)
    sum += eps;
  for (double const eps : system.particles.eps)
    squares += (eps - sum / N) * (eps - sum / N);
  return {N > 1 ? std::sqrt(squares / (N - 1)) * (1 + 0.25 / (N - 1)) : 0};
}

} // namespace

/// Its square is k_B T^2 C where a particle exchanges energy with many others.
Measurement internal_energy_spread() {
  return {.name = "internal_energy_spread",
          .meaning = "standard deviation of the particles' internal energies",
          .dimension = Dimension::energy,
          .exists = with_energies,
          .values = spread};
}

} // namespace mesobridge::sdpd
