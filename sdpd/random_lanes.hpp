#pragma once
#include "sdpd/pair/lane_math.hpp"
#include "sdpd/random.hpp"
#include <limits>

/// The noise of sixteen pairs at once, in the compiler's vector types.
namespace mesobridge::sdpd {

/// Eight words of 64 bits whose lower halves count: their products need no shuffling between lanes.
using LongBits [[gnu::vector_size(64)]] = std::uint64_t;
using HalfBits [[gnu::vector_size(32)]] = std::uint32_t;

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
      x0 = (b >> 32) ^ x1 ^ key[0];
      x2 = (a >> 32) ^ x3 ^ key[1];
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
    return __builtin_shufflevector(__builtin_convertvector(low, HalfBits),
                                   __builtin_convertvector(high, HalfBits), 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
                                   11, 12, 13, 14, 15);
  }

  std::uint64_t step_low_, step_high_and_stream_;
  std::array<std::array<std::uint64_t, 2>, Philox4x32::rounds> keys_;
};

/// sin(pi x) for |x| <= 1/2, relative error 1e-7: the polynomial of degree 9 that is nearest to it.
[[gnu::always_inline]] inline WideFloats sine_of_half_turn(WideFloats const& x) {
  WideFloats const z = x * x;
  WideFloats p = z * 0.0775603876f - 0.598242104f;
  p = z * p + 2.55006981f;
  p = z * p - 5.16770983f;
  p = z * p + 3.14159274f;
  return x * p;
}

namespace detail {

inline constexpr std::int32_t sign_bit = std::numeric_limits<std::int32_t>::min();

/// sqrt(-2 ln u) of a uniform number u in (0, 1] from the upper 31 of 32 random bits.
[[gnu::always_inline]] inline WideFloats radius(WideBits const& c) {
  WideFloats const u = (__builtin_convertvector(reinterpret<WideInts>(c >> 1), WideFloats) + 0.5f) * 0x1p-31f;
  return square_root(-2.0f * logarithm(u));
}
/// An angle in [-1, 1) half turns.
[[gnu::always_inline]] inline WideFloats turn(WideBits const& c) {
  return __builtin_convertvector(reinterpret<WideInts>(c & ~spare_of_turn), WideFloats) * 0x1p-31f;
}
[[gnu::always_inline]] inline WideFloats magnitude(WideFloats const& x) {
  return reinterpret<WideFloats>(reinterpret<WideInts>(x) & ~sign_bit);
}
/// cos(pi t) = sin(pi (1/2 - |t|))
[[gnu::always_inline]] inline WideFloats cosine(WideFloats const& turn) {
  return sine_of_half_turn(0.5f - magnitude(turn));
}
/// sin(pi t) = sin(pi s) with s nearest to 0
[[gnu::always_inline]] inline WideFloats sine(WideFloats const& turn) {
  WideFloats const nearest = 0.5f - magnitude(magnitude(turn) - 0.5f);
  WideInts const sign = reinterpret<WideInts>(turn) & sign_bit;
  return sine_of_half_turn(reinterpret<WideFloats>(reinterpret<WideInts>(nearest) | sign));
}

} // namespace detail

/// Three standard Gaussian numbers for each of sixteen pairs of ids, and random bits that are independent of
/// them, by Box and Muller's method on Philox4x32. Single precision is enough: the law is right to 1e-7,
/// and what the noise drives conserves momentum and energy to double round-off all the same. The largest
/// value is sqrt(2 ln 2^32) = 6.66.
struct GaussianLanes {
  WideFloats x, y, z;
  WideBits bits; ///< spare_bits of them

  [[gnu::always_inline]] GaussianLanes(NoiseLanes const& source, WideBits const& id_a, WideBits const& id_b)
      : GaussianLanes(source.generate(id_a, id_b)) {}
  [[gnu::always_inline]] explicit GaussianLanes(NoiseLanes::Word const& word) {
    auto const& [c0, c1, c2, c3] = word;
    WideFloats const radius = detail::radius(c0), turn = detail::turn(c1);
    x = radius * detail::cosine(turn);
    y = radius * detail::sine(turn);
    z = detail::radius(c2) * detail::cosine(detail::turn(c3));
    bits = (c1 & spare_of_turn) << 8 | (c3 & spare_of_turn);
  }
};

/// The first of the three alone, with the same bits.
struct OneGaussianLanes {
  WideFloats x;
  WideBits bits;

  [[gnu::always_inline]] explicit OneGaussianLanes(NoiseLanes::Word const& word) {
    auto const& [c0, c1, c2, c3] = word;
    x = detail::radius(c0) * detail::cosine(detail::turn(c1));
    bits = (c1 & spare_of_turn) << 8 | (c3 & spare_of_turn);
  }
};

} // namespace mesobridge::sdpd
