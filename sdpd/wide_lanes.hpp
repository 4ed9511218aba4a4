#pragma once
#include "sdpd/lanes.hpp"

/// Sixteen numbers of 32 bits that are worked on together: see lanes.hpp.
namespace mesobridge::sdpd {

inline constexpr std::size_t wide_count = 16;

using WideFloats [[gnu::vector_size(64)]] = float;
using WideInts [[gnu::vector_size(64)]] = std::int32_t;
using WideBits [[gnu::vector_size(64)]] = std::uint32_t;

/// The same bits, read as another type.
template <class To, class From>
[[gnu::always_inline]] inline To reinterpret(From const& from) {
  static_assert(sizeof(To) == sizeof(From));
  return load<To>(&from);
}

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

} // namespace mesobridge::sdpd
