#pragma once
#include "md/error.hpp"
#include <algorithm>
#include <limits>
#include <optional>

namespace mesobridge::fitting {

/// The zero of f between a and b, where f has opposite signs, to round-off in x. Inverse quadratic
/// interpolation where Chandrupatla's criterion (Adv. Eng. Softw. 28 (1997) 145) finds it safe, bisection
/// elsewhere. f_a, f_b: the values at the ends.
template <class F>
double bracketed_zero(F&& f, double a, double f_a, double b, double f_b) {
  if (f_a == 0 || f_b == 0)
    return f_a == 0 ? a : b;
  if (!(f_a < 0) == !(f_b < 0))
    throw std::logic_error("bracketed_zero: no change of sign");
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double fraction = 0.5;
  for (int iteration = 0; iteration < 200; ++iteration) {
    double const x = a + fraction * (b - a), f_x = f(x);
    // a is always the newest point, b the other end of the bracket, c the one that was dropped.
    double c = a, f_c = f_a;
    if ((f_x < 0) != (f_a < 0)) {
      c = b, f_c = f_b;
      b = a, f_b = f_a;
    }
    a = x, f_a = f_x;
    double const best = std::abs(f_a) < std::abs(f_b) ? a : b;
    double const width = std::abs(b - a);
    double const smallest = 2 * epsilon * std::abs(best) / width;
    if (f_a == 0 || smallest > 0.5 || width == 0)
      return best;
    double const xi = (a - b) / (c - b), phi = (f_a - f_b) / (f_c - f_b);
    bool const safe = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
    fraction = safe ? f_a / (f_b - f_a) * f_c / (f_b - f_c) +
                          (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b)
                    : 0.5;
    fraction = std::min(std::max(fraction, smallest), 1 - smallest);
  }
  return a;
}

template <class F>
double bracketed_zero(F&& f, double a, double b) {
  return bracketed_zero(f, a, f(a), b, f(b));
}

/// Where f first turns from negative to positive on the way from `first` to `last` (> 0, either may be the
/// larger) by steps of the given ratio. Points where f throws PhysicsError (outside a model) are passed over;
/// when the model ends between a negative value and the next step, its edge is approached by halving.
/// Nothing if f does not turn.
template <class F>
std::optional<double> first_rising_zero(F&& f, double first, double last, double ratio) {
  auto const value = [&](double x) -> std::optional<double> {
    try {
      return f(x);
    } catch (PhysicsError const&) {
      return std::nullopt;
    }
  };
  struct Point {
    double x, f;
  };
  std::optional<Point> negative;
  if (!(first > 0 && last > 0))
    return std::nullopt; // no way to go
  bool const up = last > first;
  bool at_end = false;
  for (double x = first; !at_end; x = up ? x * ratio : x / ratio) {
    if (up ? x >= last : x <= last) {
      x = last;
      at_end = true;
    }
    auto f_x = value(x);
    if (!f_x && negative) {
      double edge = x;
      constexpr int halvings = 40; // of one step: the edge to round-off
      for (int k = 0; k < halvings && !(f_x && *f_x >= 0); ++k) {
        x = 0.5 * (negative->x + edge);
        f_x = value(x);
        if (!f_x)
          edge = x;
        else if (*f_x < 0)
          negative = {x, *f_x};
      }
      if (!f_x || *f_x < 0)
        return std::nullopt;
    }
    if (!f_x)
      continue;
    if (*f_x < 0)
      negative = {x, *f_x};
    else if (negative)
      return bracketed_zero(f, negative->x, negative->f, x, *f_x);
  }
  return std::nullopt;
}

} // namespace mesobridge::fitting
