#pragma once
#include "sdpd/lanes.hpp"

namespace mesobridge::sdpd {

/// The same number in every lane, or the number itself.
template <class X>
[[gnu::always_inline]] inline X constant(double value) {
  return static_cast<float>(value) - X{};
}
template <>
[[gnu::always_inline]] inline double constant<double>(double value) {
  return value;
}

/// exp(-x) - 1 for x >= 0 without cancellation.
[[gnu::always_inline]] inline double minus_expm1(double x) {
  return std::expm1(-x);
}

/// The same in lanes, to single precision: with n the integer nearest to x/ln 2, exp(-x) - 1 =
/// 2^-n (exp(f) - 1) + (2^-n - 1), f = n ln 2 - x in [-0.35, 0.35], by the series of exp(f) - 1 up to f^7.
[[gnu::always_inline]] inline FloatLanes minus_expm1(FloatLanes const& argument) {
  constexpr float ln2_high = 0.693359375f, ln2_low = -2.12194440e-4f; // their sum is ln 2
  constexpr float to_integer = 12582912.0f;                           // 1.5 * 2^23: adding it rounds
  FloatLanes const most = constant<FloatLanes>(80);                   // exp(-80) is nothing beside 1
  FloatLanes const x = argument < most ? argument : most;
  FloatLanes const shifted = x * 1.44269504f + to_integer, n = shifted - to_integer;
  FloatLanes const f = (n * ln2_high - x) + n * ln2_low;
  FloatLanes series = 1.0f / 720.0f + f * (1.0f / 5040.0f);
  series = 1.0f / 120.0f + f * series;
  series = 1.0f / 24.0f + f * series;
  series = 1.0f / 6.0f + f * series;
  series = 0.5f + f * series;
  series = f + f * f * series;
  IntLanes const exponent = (127 - __builtin_convertvector(n, IntLanes)) << 23;
  FloatLanes const power = load<FloatLanes>(&exponent);
  return power * series + (power - 1.0f);
}

} // namespace mesobridge::sdpd
