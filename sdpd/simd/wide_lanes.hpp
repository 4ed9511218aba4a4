#pragma once
#include "sdpd/simd/lanes.hpp"

/// Sixteen numbers of 32 bits that are worked on together: see lanes.hpp.
namespace mesobridge::sdpd {

inline constexpr std::size_t wide_count = 16;

using WideFloats [[gnu::vector_size(64)]] = float;
using WideInts [[gnu::vector_size(64)]] = std::int32_t;
using WideBits [[gnu::vector_size(64)]] = std::uint32_t;

[[gnu::always_inline]] inline WideFloats join(FloatLanes const& low, FloatLanes const& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
[[gnu::always_inline]] inline FloatLanes low_half(WideFloats const& x) {
  return __builtin_shufflevector(x, x, 0, 1, 2, 3, 4, 5, 6, 7);
}
[[gnu::always_inline]] inline FloatLanes high_half(WideFloats const& x) {
  return __builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15);
}

[[gnu::always_inline]] inline WideFloats square_root(WideFloats const& x) {
#ifdef __AVX512VL__
  return _mm512_maskz_sqrt_ps(0xffff, x);
#else
  return join(square_root(low_half(x)), square_root(high_half(x)));
#endif
}

/// 1/sqrt(x) for x >= 1e-30, to 2 units in the last place.
[[gnu::always_inline]] inline WideFloats inverse_square_root(WideFloats const& x) {
#ifdef __AVX512VL__
  WideFloats const y =
      _mm512_maskz_rsqrt14_ps(0xffff, x); // right to 2^-14; Newton's iteration doubles the digits
  return y * (1.5f - 0.5f * x * y * y);
#else
  return 1.0f / square_root(x);
#endif
}

/// Distances from their squares. Two particles in one place count as sqrt(least) apart, so that e = 0.
template <class X>
struct Distances {
  static constexpr double least = std::is_same_v<X, Lanes> ? 1e-290 : 1e-30;
  X r, inverse_r;

  [[gnu::always_inline]] explicit Distances(X const& r2) {
    X const smallest = constant<X>(least), safe = r2 < smallest ? smallest : r2;
    inverse_r = inverse_square_root(safe);
    r = safe * inverse_r;
  }
};
using DistanceLanes = Distances<Lanes>;
using WideDistances = Distances<WideFloats>;

/// Bit l is set where a < b in lane l.
[[gnu::always_inline]] inline unsigned less(WideFloats const& a, WideFloats const& b) {
#ifdef __AVX512VL__
  return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ);
#else
  unsigned bits = 0;
  for (std::size_t l = 0; l < wide_count; ++l)
    bits |= unsigned{a[l] < b[l]} << l;
  return bits;
#endif
}

/// Writes the lanes whose bits are set to `to`, close together; writes past them, up to wide_count values.
[[gnu::always_inline]] inline void compress(unsigned bits, WideBits const& values, void* to) {
#ifdef __AVX512VL__
  store(_mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), reinterpret<__m512i>(values)), to);
#else
  WideBits close{};
  std::size_t count = 0;
  for (std::size_t l = 0; l < wide_count; ++l) {
    close[count] = values[l];
    count += bits >> l & 1u;
    count %= wide_count; // all sixteen: nothing follows
  }
  store(close, to);
#endif
}

/// values[index] lane by lane.
[[gnu::always_inline]] inline WideBits gather(std::uint32_t const* values, WideBits const& index) {
#ifdef __AVX512VL__
  return reinterpret<WideBits>(_mm512_mask_i32gather_epi32(
      _mm512_setzero_si512(), 0xffff, reinterpret<__m512i>(index), values, sizeof *values));
#else
  WideBits found;
  for (std::size_t l = 0; l < wide_count; ++l)
    found[l] = values[index[l]];
  return found;
#endif
}

/// Four numbers of one particle, in a quarter of a cache line.
using FloatRow [[gnu::vector_size(16)]] = float;
/// Four quantities of sixteen particles: quantity[k][l] belongs to the particle of lane l.
using WideRowLanes = std::array<WideFloats, 4>;

/// Reads the row at row_of(l) for each lane l and turns rows into quantities.
template <class RowOf>
[[gnu::always_inline]] inline WideRowLanes load_wide_rows(RowOf const& row_of) {
  auto pair = [&](std::size_t l) [[gnu::always_inline]] {
    return __builtin_shufflevector(load<FloatRow>(row_of(l)), load<FloatRow>(row_of(l + 4)), 0, 1, 2, 3, 4, 5,
                                   6, 7);
  };
  auto four = [&](std::size_t l) [[gnu::always_inline]] { return join(pair(l), pair(l + 8)); };
  auto low = [](WideFloats const& a, WideFloats const& b) [[gnu::always_inline]] {
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
  };
  auto high = [](WideFloats const& a, WideFloats const& b) [[gnu::always_inline]] {
    return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
  };
  WideFloats const a = four(0), b = four(1), c = four(2), d = four(3);
  WideFloats const ac_low = low(a, c), bd_low = low(b, d), ac_high = high(a, c), bd_high = high(b, d);
  return {low(ac_low, bd_low), high(ac_low, bd_low), low(ac_high, bd_high), high(ac_high, bd_high)};
}

} // namespace mesobridge::sdpd
