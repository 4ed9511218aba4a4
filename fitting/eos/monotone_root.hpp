#pragma once
#include <cmath>
#include <optional>

namespace mesobridge::fitting {

/// An increasing function's value with two derivatives.
struct Jet {
  double value, slope, curvature;
};

inline double halley_step(Jet const& f, double target) {
  double const newton = (target - f.value) / f.slope;
  return newton / (1 + 0.5 * newton * f.curvature / f.slope);
}

/// The x > 0 in [low, high] where the increasing function takes the value `target`, to round-off, or nothing
/// when the target (a NaN, too) is not between the values at the ends. jet(x) returns a Jet. Halley's steps
/// inside a bracket that every evaluation narrows; a step that leaves the bracket is replaced by its
/// geometric middle, so that it always ends.
template <class F>
std::optional<double> solve_in_bracket(F&& jet, double target, double low, double high) {
  constexpr double last_digits = 4e-16;
  if (!(target >= jet(low).value && target <= jet(high).value))
    return std::nullopt;
  double x = std::sqrt(low * high);
  for (int iteration = 0; iteration < 200; ++iteration) {
    Jet const f = jet(x);
    (f.value < target ? low : high) = x;
    double next = x + halley_step(f, target);
    if (!(next >= low && next <= high))
      next = std::sqrt(low * high);
    if (std::abs(next - x) <= last_digits * x)
      return next;
    x = next;
  }
  return x; // steps that dither in the last digits
}

/// The same from a guess (any number): two or three evaluations when it is near.
template <class F>
std::optional<double> solve_increasing(F&& jet, double target, double low, double high, double guess) {
  // The error after a Halley step is of third order: a step below 1e-6 x leaves round-off only.
  constexpr double small = 1e-6;
  double x = guess;
  for (int iteration = 0; iteration < 6 && x >= low && x <= high; ++iteration) {
    double const step = halley_step(jet(x), target);
    x += step;
    if (std::abs(step) <= small * x && x >= low && x <= high)
      return x;
  }
  return solve_in_bracket(jet, target, low, high);
}

} // namespace mesobridge::fitting
