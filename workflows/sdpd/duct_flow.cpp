#include "workflows/sdpd/duct_flow.hpp"
#include <cmath>
#include <numbers>

namespace mesobridge::workflows {
namespace {

constexpr int terms = 199; ///< odd ones up to it
constexpr double pi = std::numbers::pi;

/// cosh(k y)/cosh(k b/2) for |y| <= b/2, also where both are too large for a number.
double ratio_of_cosh(double k, double y, double b) {
  double const from_wall = k * (std::abs(y) - b / 2);
  return std::exp(from_wall) * (1 + std::exp(-2 * k * std::abs(y))) / (1 + std::exp(-k * b));
}

/// The flow between two planes, z (a - z)/2, less what the other two walls take: the sum over odd n of
/// 4 a^2/(pi n)^3 (-1)^((n-1)/2) cos(n pi (z - a/2)/a) taken(n pi/a). The planes' flow is the same series
/// with taken = 1, whose end would be missed near the walls.
template <class Taken>
double between_planes_less(double z, double a, Taken const& taken) {
  double v = z * (a - z) / 2;
  for (int n = 1; n <= terms; n += 2) {
    double const k = n * pi / a, sign = n % 4 == 1 ? 1 : -1;
    v -= 4 * a * a / std::pow(n * pi, 3) * sign * std::cos(k * (z - a / 2)) * taken(k);
  }
  return v;
}

} // namespace

double Duct::velocity(double z) const {
  return between_planes_less(z, a, [&](double k) { return std::tanh(k * b / 2) / (k * b / 2); });
}

double Duct::velocity(double z, double y) const {
  return between_planes_less(z, a, [&](double k) { return ratio_of_cosh(k, y - b / 2, b); });
}

double Duct::mean_velocity() const {
  double sum = a * a / 12;
  for (int n = 1; n <= terms; n += 2)
    sum -= 16 * a * a * a / (b * std::pow(n * pi, 5)) * std::tanh(n * pi * b / (2 * a));
  return sum;
}

} // namespace mesobridge::workflows
