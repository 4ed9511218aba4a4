#include "fitting/eos/lj_bwr_isochore.hpp"
#include "md/error.hpp"

namespace mesobridge::fitting {

template <>
void BasicLjBwrIsochore<double>::refuse(double target, Given given, std::string_view why) const {
  bool const energy = given == Given::energy;
  throw PhysicsError(fmt::format(
      "LJ-BWR at density {} (rho* = {:.6g}): {} {} (reduced {:.6g}) {}; the domain is 0 < T* <= {}",
      density(), rho_, energy ? "energy" : "entropy",
      target * (energy ? e_unit() : scale_.specific_entropy()), target, why, T_max_));
}

template <>
double BasicLjBwrIsochore<double>::solve_in_bracket(double target, Given given) const {
  double low = A_.T_low(), high = T_max_;
  double t = std::sqrt(low * high);
  // Halving the logarithm of the bracket needs 60 steps for round-off; the Newton steps make it fewer.
  for (int iteration = 0; iteration < 200; ++iteration) {
    Jet const f = given == Given::energy ? energy_jet(t) : entropy_jet(t);
    (f.value < target ? low : high) = t;
    double next = t + (target - f.value) / f.slope;
    if (!(next > low && next < high))
      next = std::sqrt(low * high);
    if (std::abs(next - t) <= 4e-16 * t)
      return next;
    t = next;
  }
  return t; // Newton steps that dither in the last digits
}

template <>
double BasicLjBwrIsochore<double>::solve_safely(double target, Given given) const {
  double const T_low = A_.T_low();
  auto value = [&](double t) { return given == Given::energy ? energy_jet(t).value : entropy_jet(t).value; };
  if (!std::isfinite(target))
    refuse(target, given, "is not a finite number");
  double const above_low = target - value(T_low), C = 1.5 + A_.heat_capacity(T_low);
  if (above_low < 0) {
    double const t = given == Given::energy ? T_low + above_low / C : T_low * std::exp(above_low / C);
    if (!(t > 0))
      refuse(target, given, "lies below that of T = 0");
    return t;
  }
  if (target > value(T_max_))
    refuse(target, given, "lies above that of the highest temperature");
  return solve_in_bracket(target, given);
}

} // namespace mesobridge::fitting
