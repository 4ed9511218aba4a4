#include "sdpd/method/mean_field_viscosity.hpp"
#include <numbers>

namespace mesobridge::sdpd {
namespace {

/// 4 pi times the integral of f(r) r^power from 0 to `end` (midpoints: the integrands end smoothly).
template <class F>
double shell_integral(F const& f, double end, int power) {
  constexpr int count = 4000;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    double const r = (k + 0.5) * end / count;
    sum += f(r) * std::pow(r, power);
  }
  return 4 * std::numbers::pi * sum * end / count;
}

MeanFieldViscosity of(Sdpd const& fluid, SimulationSettings const& at) {
  auto const units = at.units();
  double const eta = fluid.eta / units.viscosity(), zeta = fluid.zeta / units.viscosity(), h = at.range();
  double const of_F = std::visit(
      [&](auto const& kernel) { return shell_integral([&](double r) { return kernel.F(r, 1 / r); }, h, 2); },
      make_kernel(fluid.kernel, h));
  double const rate = (20 * eta / 9 + 2 * zeta / 3) * of_F;
  return {fluid.eta, units.viscosity() / (2 * units.K * rate)};
}

MeanFieldViscosity of(PairFluid const& fluid, SimulationSettings const& at) {
  double const n = at.rho / fluid.mass, end = fluid.friction_cutoff();
  auto const integral = [&](double par, double perp, int power) {
    return std::visit(
        [&](auto const& shape) {
          return shell_integral(
              [&](double r) {
                auto const weight = shape(r);
                return par * weight.par + perp * weight.perp;
              },
              end, power);
        },
        fluid.friction);
  };
  double const rate = n / (3 * fluid.mass) * integral(1, 2, 2);
  return {n * n / 30 * integral(1, 4, 4), n * fluid.boltzmann * at.T / (2 * rate)};
}

} // namespace

MeanFieldViscosity mean_field_viscosity(SimulationSettings const& settings) {
  return std::visit([&](auto const& method) { return of(method, settings); }, settings.method);
}

double usual_wall_friction(SimulationSettings const& settings) {
  constexpr double largest = 1000;
  auto const [dissipative, kinetic] = mean_field_viscosity(settings);
  double const carried = std::min(kinetic / dissipative, largest);
  return settings.features().densities ? 1 + 4 * carried : 4 * (1 + carried);
}

} // namespace mesobridge::sdpd
