#include "md/quasiharmonic_metal.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include <cmath>

namespace mesobridge::md {

namespace {

constexpr double grueneisen = 2;

} // namespace

QuasiharmonicMetal::QuasiharmonicMetal(MpiWorld const& world, MetalSettings const& settings)
    : crystal_(world, settings.potential, settings.lattice, settings.log_file, Log::append),
      mass_(settings.potential.mass) {}

double QuasiharmonicMetal::thermal_energy(double T) const {
  return 3 * k_B * T / mass_;
}

double QuasiharmonicMetal::zero_pressure_density(double T) {
  auto const ground = crystal_.at_zero_pressure();
  double const c = crystal_.bulk_sound_speed(ground.rho);
  return ground.rho * (1 - grueneisen * thermal_energy(T) / (c * c));
}

QuasiharmonicMetal::Shocked QuasiharmonicMetal::shocked(MetalState initial, double rho, Squeeze squeeze) {
  auto const cold0 = crystal_.at(initial.rho), cold = squeeze == Squeeze::evenly
                                                          ? crystal_.at(rho)
                                                          : crystal_.squeezed_along_z(initial.rho, rho);
  double const P0 = cold0.P + grueneisen * initial.rho * thermal_energy(initial.T);
  double const dv = 1 / initial.rho - 1 / rho;
  double const part = 1 - grueneisen * rho * dv / 2;
  double const thermal = ((cold.P + P0) * dv / 2 - (cold.e - cold0.e) + thermal_energy(initial.T)) / part;
  if (!(part > 0.1 && thermal > 0 && cold.P > cold0.P))
    throw PhysicsError(
        fmt::format("no shocked state is to be expected at {:.1f} kg/m^3 from {:.1f} kg/m^3, {} K: "
                    "choose a compression nearer to 1",
                    rho, initial.rho, initial.T));
  double const P = cold.P + grueneisen * rho * thermal;
  if (!(P > P0))
    throw PhysicsError(
        fmt::format("the estimate of a shock from {:.1f} to {:.1f} kg/m^3 has a pressure of {:.4g} Pa, "
                    "which is not above that ahead, {:.4g} Pa",
                    initial.rho, rho, P, P0));
  return {.T = initial.T * thermal / thermal_energy(initial.T), .v_P = std::sqrt((P - P0) * dv), .P = P};
}

double QuasiharmonicMetal::compression(MetalState initial, double v_P, Squeeze squeeze) {
  constexpr double weakest = 1.001, strongest = 1.7;
  auto const v_P_at = [&](double compression) {
    return shocked(initial, compression * initial.rho, squeeze).v_P;
  };
  double const slowest = v_P_at(weakest), fastest = v_P_at(strongest);
  require(v_P > slowest && v_P < fastest, "v_P [m/s]", v_P,
          fmt::format("must be {:.0f} ... {:.0f}", slowest, fastest));
  double low = weakest, high = strongest;
  while (high - low > 1e-6) {
    double const middle = (low + high) / 2;
    (v_P_at(middle) < v_P ? low : high) = middle;
  }
  return (low + high) / 2;
}

} // namespace mesobridge::md
