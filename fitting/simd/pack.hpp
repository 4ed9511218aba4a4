#pragma once
#include "fitting/simd/lanes.hpp"
#include <bit>

namespace mesobridge::fitting {

/// As many doubles as fill a vector register, as one number: a formula that is a template on its number type
/// is evaluated for all of them at once.
struct Pack {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  static constexpr int size = 8;
#elif defined(__AVX2__)
  static constexpr int size = 4;
#else
  static constexpr int size = 2;
#endif
  using Vector = double __attribute__((vector_size(size * sizeof(double))));
  using Integers = std::int64_t __attribute__((vector_size(size * sizeof(double))));

  Vector v;

  Pack() = default;
  Pack(Vector vector) : v(vector) {}
  Pack(double x) : v(simd::constant<Vector>(x)) {}

  static Pack load(double const* from) {
    return simd::load<Vector>(from);
  }
  void store(double* to) const {
    simd::store(v, to);
  }

  friend Pack operator+(Pack a, Pack b) {
    return a.v + b.v;
  }
  friend Pack operator-(Pack a, Pack b) {
    return a.v - b.v;
  }
  friend Pack operator*(Pack a, Pack b) {
    return a.v * b.v;
  }
  friend Pack operator/(Pack a, Pack b) {
    return a.v / b.v;
  }
  friend Pack operator-(Pack a) {
    return -a.v;
  }
  friend Pack& operator+=(Pack& a, Pack b) {
    return a = a + b;
  }
  friend Pack& operator*=(Pack& a, Pack b) {
    return a = a * b;
  }
};

/// Truth in every lane: all bits set, or none.
using PackMask = Pack::Integers;

/// mask ? a : b
inline Pack select(PackMask mask, Pack a, Pack b) {
  return Pack::Vector(mask ? a.v : b.v);
}

/// Whether low < x < high, lane by lane; false for a NaN.
inline PackMask between(Pack x, double low, double high) {
  return (x.v > low) & (x.v < high);
}

/// Whether the mask is true in every lane.
inline bool all_of(PackMask mask) {
  std::int64_t all = -1;
  for (int lane = 0; lane < Pack::size; ++lane)
    all &= mask[lane];
  return all != 0;
}

/// x >= 0 ? not_negative : negative
inline Pack by_sign(Pack x, double not_negative, double negative) {
  return Pack::Vector(x.v >= 0 ? Pack(not_negative).v : Pack(negative).v);
}

namespace pack {

/// ln 2 as a sum whose first part has 33 bits, so that its multiples by exponents are exact.
inline constexpr double ln_2_high = 0x1.62e42feep-1, ln_2_low = 0x1.a39ef35793c76p-33;

/// c[0] + x (c[1] + x (...))
template <std::size_t N>
Pack::Vector polynomial(Pack::Vector x, double const (&c)[N]) {
  Pack::Vector sum = Pack(c[N - 1]).v;
  for (std::size_t k = N - 1; k-- > 0;)
    sum = sum * x + c[k];
  return sum;
}

} // namespace pack

/// Right to about one unit in the last place; overflows to infinity, underflows to zero, a NaN stays one.
/// exp(x) = 2^n exp(r), |r| <= ln(2)/2, the latter by its Taylor series (the next term is below 1e-17).
inline Pack exp(Pack x) {
  constexpr double beyond = 800, shift = 0x1.8p52;
  constexpr double series[] = {1,
                               1,
                               1.0 / 2,
                               1.0 / 6,
                               1.0 / 24,
                               1.0 / 120,
                               1.0 / 720,
                               1.0 / 5040,
                               1.0 / 40320,
                               1.0 / 362880,
                               1.0 / 3628800,
                               1.0 / 39916800,
                               1.0 / 479001600,
                               1.0 / 6227020800};
  auto bounded = x.v > beyond ? Pack(beyond).v : x.v;
  bounded = bounded < -beyond ? Pack(-beyond).v : bounded;
  // Adding the shift leaves the nearest integer in the low bits.
  Pack::Vector const shifted = bounded * 1.4426950408889634 + shift, n = shifted - shift;
  Pack::Vector const r = (bounded - n * pack::ln_2_high) - n * pack::ln_2_low;
  auto const exponent = std::bit_cast<Pack::Integers>(shifted) - std::bit_cast<std::int64_t>(shift);
  // 2^n in two factors: n may be twice what one of them can hold.
  auto const half = exponent >> 1, rest = exponent - half;
  auto const power = [](Pack::Integers k) { return std::bit_cast<Pack::Vector>((k + 1023) << 52); };
  return pack::polynomial(r, series) * power(half) * power(rest);
}

/// For normal positive x; right to about one unit in the last place. x = 2^k m, sqrt(1/2) <= m < sqrt(2),
/// ln m = 2 atanh(s), s = (m-1)/(m+1), by its series in s^2 < 0.03.
inline Pack log(Pack x) {
  constexpr std::int64_t root_half = 0x3fe6a09e667f3bcd; // sqrt(1/2)
  constexpr double series[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                               2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
  auto const bits = std::bit_cast<Pack::Integers>(x.v);
  auto const k = (bits - root_half) >> 52;
  auto const f = std::bit_cast<Pack::Vector>(bits - (k << 52)) - 1.0, s = f / (2.0 + f), z = s * s;
  auto const n = __builtin_convertvector(k, Pack::Vector);
  return n * pack::ln_2_high + (2.0 * s + (s * z * pack::polynomial(z, series) + n * pack::ln_2_low));
}

/// The square root of x >= 0, correctly rounded.
inline Pack sqrt(Pack x) {
  Pack root;
  for (int lane = 0; lane < Pack::size; ++lane)
    root.v[lane] = __builtin_sqrt(x.v[lane]);
  return root;
}

/// Whether 0 < x < bound in all of them; false for a NaN.
inline bool all_between_zero_and(Pack x, double bound) {
  return all_of(between(x, 0, bound));
}

/// Whether low <= x <= high in all of them; false for a NaN.
inline bool all_within(Pack x, double low, double high) {
  return all_of((x.v >= low) & (x.v <= high));
}

} // namespace mesobridge::fitting
