#pragma once
#include "sdpd/simd/lane_math.hpp"
#include "sdpd/state/random.hpp"
#include <bit>

/// The noise of sixteen pairs at once, in the compiler's vector types.
namespace mesobridge::sdpd {

/// Eight words of 64 bits whose lower halves count: their products need no shuffling between lanes.
using LongBits [[gnu::vector_size(64)]] = std::uint64_t;

/// The product of the lower halves.
[[gnu::always_inline]] inline LongBits product(LongBits const& a, std::uint32_t b) {
  LongBits const factor = b - LongBits{};
#ifdef __AVX512VL__
  return reinterpret<LongBits>(
      _mm512_maskz_mul_epu32(0xff, reinterpret<__m512i>(a), reinterpret<__m512i>(factor)));
#else
  return (a & 0xffffffffu) * factor;
#endif
}

[[gnu::always_inline]] inline LongBits exclusive_or(LongBits const& a, LongBits const& b, LongBits const& c) {
#ifdef __AVX512VL__
  constexpr int parity = 0x96; // GCC 12 makes two instructions of a ^ b ^ c
  return reinterpret<LongBits>(_mm512_maskz_ternarylogic_epi64(
      0xff, reinterpret<__m512i>(a), reinterpret<__m512i>(b), reinterpret<__m512i>(c), parity));
#else
  return a ^ b ^ c;
#endif
}

/// Counter and keys of a noise source as its sixteen lanes need them.
class NoiseLanes {
 public:
  explicit NoiseLanes(NoiseSource const& source)
      : step_low_(source.step_low), step_high_and_stream_(source.step_high_and_stream) {
    auto [k0, k1] = source.key;
    for (auto& key : keys_) {
      key = {k0, k1};
      k0 += Philox4x32::weyl_0, k1 += Philox4x32::weyl_1;
    }
  }

  struct Word {
    WideBits c0, c1, c2, c3;
  };
  /// Philox4x32 of the counters (a, b, step, stream).
  [[gnu::always_inline]] Word generate(WideBits const& a, WideBits const& b) const {
    Half low{widen<0>(a), widen<0>(b), step_low_ - LongBits{}, step_high_and_stream_ - LongBits{}};
    Half high{widen<1>(a), widen<1>(b), low.x2, low.x3};
    for (auto const& key : keys_) {
      low.round(key);
      high.round(key);
    }
    return {narrow(low.x0, high.x0), narrow(low.x1, high.x1), narrow(low.x2, high.x2),
            narrow(low.x3, high.x3)};
  }

 private:
  /// Eight of the lanes. The upper halves fill with rubbish that nothing reads.
  struct Half {
    LongBits x0, x1, x2, x3;

    [[gnu::always_inline]] void round(std::array<std::uint64_t, 2> const& key) {
      LongBits const a = product(x0, Philox4x32::multiplier_0), b = product(x2, Philox4x32::multiplier_1);
      x0 = exclusive_or(b >> 32, x1, key[0] - LongBits{});
      x2 = exclusive_or(a >> 32, x3, key[1] - LongBits{});
      x1 = b;
      x3 = a;
    }
  };

  template <int half>
  [[gnu::always_inline]] static LongBits widen(WideBits const& bits) {
    if constexpr (half == 0)
      return __builtin_convertvector(__builtin_shufflevector(bits, bits, 0, 1, 2, 3, 4, 5, 6, 7), LongBits);
    else
      return __builtin_convertvector(__builtin_shufflevector(bits, bits, 8, 9, 10, 11, 12, 13, 14, 15),
                                     LongBits);
  }
  [[gnu::always_inline]] static WideBits narrow(LongBits const& low, LongBits const& high) {
    static_assert(std::endian::native == std::endian::little);
    return __builtin_shufflevector(reinterpret<WideBits>(low), reinterpret<WideBits>(high), 0, 2, 4, 6, 8, 10,
                                   12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  }

  std::uint64_t step_low_, step_high_and_stream_;
  std::array<std::array<std::uint64_t, 2>, Philox4x32::rounds> keys_;
};

/// sin(pi x) for |x| <= 1/2, relative error 2e-7: the polynomial of degree 9 that is nearest to it.
[[gnu::always_inline]] inline WideFloats sine_of_half_turn(WideFloats const& x) {
  WideFloats const z = x * x;
  WideFloats p = z * 0.0775603876f - 0.598242104f;
  p = z * p + 2.55006981f;
  p = z * p - 5.16770983f;
  p = z * p + 3.14159274f;
  return x * p;
}

/// cos(pi x) for |x| <= 1/2 to 2e-7: the polynomial of degree 8 that is nearest to it.
[[gnu::always_inline]] inline WideFloats cosine_of_half_turn(WideFloats const& x) {
  WideFloats const z = x * x;
  WideFloats p = z * 0.219696798f - 1.33188016f;
  p = z * p + 4.05841191f;
  p = z * p - 4.93479286f;
  return z * p + 1.0f;
}

namespace detail {

/// -2 ln(x/2^31) of numbers x in [1/2, 2^31], relative error 2e-7: x = 2^(31 + e) m with m in [sqrt(1/2),
/// sqrt(2)), and for ln m the nearest polynomial in f = m - 1 that is right in f = 0.
[[gnu::always_inline]] inline WideFloats minus_two_logarithm(WideFloats const& x) {
  constexpr std::int32_t one = 0x3f800000, root_half = 0x3f3504f3, mantissa = 0x007fffff, exponents = 1 << 23;
  // Adding the gap between 1 and sqrt(1/2) moves the exponent's boundary to sqrt(1/2).
  WideInts const shifted = reinterpret<WideInts>(x) + (one - root_half - (127 + 31) * exponents);
  WideFloats const e = __builtin_convertvector(shifted >> 23, WideFloats);
  WideFloats const f = reinterpret<WideFloats>((shifted & mantissa) + root_half) - 1.0f;
  WideFloats p = f * -0.17919837f + 0.289643767f;
  p = p * f - 0.298347527f;
  p = p * f + 0.33087475f;
  p = p * f - 0.399168344f;
  p = p * f + 0.500058923f;
  p = p * f - 0.666683209f;
  p = p * f + 0.999999555f;
  p = p * f - 2.0f;
  return p * f - 1.38629436f * e;
}

/// sqrt(-2 ln u) of a uniform number u in (0, 1] from the upper 31 of 32 random bits.
[[gnu::always_inline]] inline WideFloats radius(WideBits const& c) {
  return square_root(
      minus_two_logarithm(__builtin_convertvector(reinterpret<WideInts>(c >> 1), WideFloats) + 0.5f));
}
/// Sine and cosine of an angle that is uniform in (0, pi), in the middles of 2^23 intervals so that the
/// cosine's mean is 0: x half turns less than a quarter turn.
struct HalfTurn {
  WideFloats x;

  [[gnu::always_inline]] explicit HalfTurn(WideBits const& c)
      : x((0.5f - 0x1p-24f) -
          __builtin_convertvector(reinterpret<WideInts>(c & ~(sign_bit | spare_of_turn)), WideFloats) *
              0x1p-31f) {}
  [[gnu::always_inline]] WideFloats cosine() const { return sine_of_half_turn(x); }
  [[gnu::always_inline]] WideFloats sine() const { return cosine_of_half_turn(x); }
};
[[gnu::always_inline]] inline WideFloats signed_as(WideBits const& c, WideFloats const& magnitude) {
  return reinterpret<WideFloats>(reinterpret<WideBits>(magnitude) ^ (c & sign_bit));
}

} // namespace detail

/// Three standard Gaussian numbers for each of sixteen pairs of ids, and random bits that are independent of
/// them, by Box and Muller's method on Philox4x32. Single precision is enough: the law is right to 2e-7,
/// and what the noise drives conserves momentum and energy to double round-off all the same. The largest
/// value is sqrt(2 ln 2^32) = 6.66.
struct GaussianLanes {
  WideFloats x, y, z;
  WideBits bits; ///< spare_bits of them

  [[gnu::always_inline]] GaussianLanes(NoiseLanes const& source, WideBits const& id_a, WideBits const& id_b)
      : GaussianLanes(source.generate(id_a, id_b)) {}
  [[gnu::always_inline]] explicit GaussianLanes(NoiseLanes::Word const& word) {
    auto const& [c0, c1, c2, c3] = word;
    WideFloats const radius = detail::radius(c0);
    detail::HalfTurn const turn(c1);
    x = radius * turn.cosine();
    y = detail::signed_as(c1, radius * turn.sine());
    z = detail::radius(c2) * detail::HalfTurn(c3).cosine();
    bits = (c1 & spare_of_turn) << 8 | (c3 & spare_of_turn);
  }
};

/// The first of the three alone, with the same bits.
struct OneGaussianLanes {
  WideFloats x;
  WideBits bits;

  [[gnu::always_inline]] explicit OneGaussianLanes(NoiseLanes::Word const& word) {
    auto const& [c0, c1, c2, c3] = word;
    x = detail::radius(c0) * detail::HalfTurn(c1).cosine();
    bits = (c1 & spare_of_turn) << 8 | (c3 & spare_of_turn);
  }
};

} // namespace mesobridge::sdpd
