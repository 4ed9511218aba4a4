#include "sdpd/method/step_diffusion.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include <cmath>
#include <limits>

namespace mesobridge::sdpd {

double velocity_decay_rate(SimulationSettings const& settings) {
  double const kinetic = mean_field_viscosity(settings).kinetic / settings.units().viscosity();
  return std::pow(settings.spacing(), -3) / (2 * settings.K() * kinetic);
}

double diffusion_excess(double rate, double step) {
  double const x = 0.5 * rate * step;
  return x < 1e-4 ? x * x / 3 : x / std::tanh(x) - 1;
}

double step_of_diffusion_excess(double rate, double share) {
  if (!(rate > 0))
    return std::numeric_limits<double>::infinity();
  double low = 0, high = 4 / rate; // x = 2, an excess of 1.07
  for (int k = 0; k < 60; ++k) {
    double const middle = 0.5 * (low + high);
    (diffusion_excess(rate, middle) < share ? low : high) = middle;
  }
  return low;
}

} // namespace mesobridge::sdpd
