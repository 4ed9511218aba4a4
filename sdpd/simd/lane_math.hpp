#pragma once
#include "sdpd/simd/wide_lanes.hpp"

namespace mesobridge::sdpd {

/// exp(-x) - 1 for x >= 0 without cancellation.
[[gnu::always_inline]] inline double minus_expm1(double x) {
  return std::expm1(-x);
}

namespace detail {

/// The same in lanes of floats, to single precision, with the integers of that many lanes: with n the integer
/// nearest to x/ln 2, exp(-x) - 1 = 2^-n (exp(f) - 1) + (2^-n - 1), f = n ln 2 - x in [-0.35, 0.35], by the
/// series of exp(f) - 1 up to f^7.
template <class Integers, class Floats>
[[gnu::always_inline]] inline Floats minus_expm1(Floats const& argument) {
  constexpr float ln2_high = 0.693359375f, ln2_low = -2.12194440e-4f; // their sum is ln 2
  constexpr float to_integer = 12582912.0f;                           // 1.5 * 2^23: adding it rounds
  Floats const most = constant<Floats>(80);                           // exp(-80) is nothing beside 1
  Floats const x = argument > most ? most : argument;                 // a NaN stays one
  Floats const shifted = x * 1.44269504f + to_integer, n = shifted - to_integer;
  Floats const f = (n * ln2_high - x) + n * ln2_low;
  Floats series = 1.0f / 720.0f + f * (1.0f / 5040.0f);
  series = 1.0f / 120.0f + f * series;
  series = 1.0f / 24.0f + f * series;
  series = 1.0f / 6.0f + f * series;
  series = 0.5f + f * series;
  series = f + f * f * series;
  Integers const exponent = (127 - __builtin_convertvector(n, Integers)) << 23;
  Floats const power = reinterpret<Floats>(exponent);
  return power * series + (power - 1.0f);
}

} // namespace detail

[[gnu::always_inline]] inline FloatLanes minus_expm1(FloatLanes const& x) {
  return detail::minus_expm1<IntLanes>(x);
}
[[gnu::always_inline]] inline WideFloats minus_expm1(WideFloats const& x) {
  return detail::minus_expm1<WideInts>(x);
}

/// The same in double precision, to a few units of round-off: the series up to f^13.
[[gnu::always_inline]] inline Lanes minus_expm1(Lanes const& argument) {
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  constexpr double to_integer = 6755399441055744.0; // 1.5 * 2^52: adding it rounds
  Lanes const most = broadcast(700);                // exp(-700) is nothing beside 1
  Lanes const x = argument > most ? most : argument;
  Lanes const n = (x * 1.44269504088896340736 + to_integer) - to_integer;
  Lanes const f = (n * ln2_high - x) + n * ln2_low;
  Lanes series = broadcast(1.0 / 6227020800); // 1/13!
  for (double const inverse_factorial :
       {1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
        1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5})
    series = inverse_factorial + f * series;
  series = f + f * f * series;
  LongLanes const exponent = (1023 - __builtin_convertvector(n, LongLanes)) << 52;
  Lanes const power = load<Lanes>(&exponent);
  return power * series + (power - 1.0);
}

/// exp(min(x, 0)), to single precision; a NaN stays one.
template <class Floats>
[[gnu::always_inline]] inline Floats exp_up_to_one(Floats const& x) {
  return 1.0f + minus_expm1(x >= 0.0f ? Floats{} : -x);
}

/// ln x of normal numbers x > 0, to 2 units of round-off: x = 2^k m with m in [sqrt(1/2), sqrt(2)), and
/// ln m = 2 artanh f by its series, f = (m - 1)/(m + 1) in [-0.172, 0.172]. Anything for other x.
[[gnu::always_inline]] inline Lanes logarithm(Lanes const& x) {
  constexpr std::int64_t one = 0x3ff0000000000000, root_half = 0x3fe6a09e667f3bcd,
                         mantissa = 0x000fffffffffffff;
  // Adding the gap between 1 and sqrt(1/2) moves the exponent's boundary to sqrt(1/2).
  LongLanes const shifted = load<LongLanes>(&x) + (one - root_half);
  Lanes const exponent = __builtin_convertvector((shifted >> 52) - 1023, Lanes);
  LongLanes const bits = (shifted & mantissa) + root_half;
  Lanes const m = load<Lanes>(&bits), f = (m - 1.0) / (m + 1.0), z = f * f;
  Lanes series = 1.0 / 19 + z * (1.0 / 21);
  series = 1.0 / 17 + z * series;
  series = 1.0 / 15 + z * series;
  series = 1.0 / 13 + z * series;
  series = 1.0 / 11 + z * series;
  series = 1.0 / 9 + z * series;
  series = 1.0 / 7 + z * series;
  series = 1.0 / 5 + z * series;
  series = 1.0 / 3 + z * series;
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  return exponent * ln2_high + (2.0 * f + (2.0 * f * z * series + exponent * ln2_low));
}

/// ln x of normal numbers x > 0, relative error 1e-7: x = m 2^e with m in [sqrt(1/2), sqrt(2)), then the
/// polynomial of the Cephes library (S. Moshier) in m - 1.
[[gnu::always_inline]] inline WideFloats logarithm(WideFloats const& x) {
  constexpr std::int32_t one = 0x3f800000, root_half = 0x3f3504f3, mantissa = 0x007fffff;
  // Adding the gap between 1 and sqrt(1/2) moves the exponent's boundary to sqrt(1/2).
  WideInts const shifted = reinterpret<WideInts>(x) + (one - root_half);
  WideFloats const exponent = __builtin_convertvector((shifted >> 23) - 127, WideFloats);
  WideFloats const f = reinterpret<WideFloats>((shifted & mantissa) + root_half) - 1.0f, z = f * f;
  WideFloats p = f * 7.0376836292e-2f - 1.1514610310e-1f;
  p = p * f + 1.1676998740e-1f;
  p = p * f - 1.2420140846e-1f;
  p = p * f + 1.4249322787e-1f;
  p = p * f - 1.6668057665e-1f;
  p = p * f + 2.0000714765e-1f;
  p = p * f - 2.4999993993e-1f;
  p = p * f + 3.3333331174e-1f;
  WideFloats const y = f * z * p - 2.12194440e-4f * exponent - 0.5f * z;
  return f + y + 0.693359375f * exponent;
}

[[gnu::always_inline]] inline double exponential(double x) {
  return std::exp(x);
}

/// exp(x) for |x| < 700, to a few units of round-off: with n the integer nearest to x/ln 2 and f = x - n ln 2
/// in [-0.35, 0.35], 2^n times the series of exp(f).
[[gnu::always_inline]] inline Lanes exponential(Lanes const& x) {
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  constexpr double to_integer = 6755399441055744.0; // 1.5 * 2^52: adding it rounds
  Lanes const n = (x * 1.44269504088896340736 + to_integer) - to_integer;
  Lanes const f = (x - n * ln2_high) - n * ln2_low;
  Lanes series = broadcast(1.0 / 6227020800); // 1/13!
  for (double const inverse_factorial :
       {1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
        1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0})
    series = inverse_factorial + f * series;
  LongLanes const bits = (__builtin_convertvector(n, LongLanes) + 1023) << 52;
  return series * load<Lanes>(&bits);
}

/// x^s for 0 < x <= 1 and s > 0.
[[gnu::always_inline]] inline double power(double x, double s) {
  return std::pow(x, s);
}
/// The same in lanes, to a few units of round-off; anything for other x.
[[gnu::always_inline]] inline Lanes power(Lanes const& x, double s) {
  Lanes const exponent = s * logarithm(x), least = broadcast(-700); // exp(-700) is nothing beside 1
  return exponential(exponent < least ? least : exponent);
}
/// The same to single precision.
[[gnu::always_inline]] inline WideFloats power(WideFloats const& x, double s) {
  return exp_up_to_one(static_cast<float>(s) * logarithm(x));
}

} // namespace mesobridge::sdpd
