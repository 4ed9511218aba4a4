#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#ifdef __AVX512VL__
#include <immintrin.h>
#endif

/// Numbers that are worked on together, in the compiler's vector types (GCC, Clang): arithmetic, comparisons
/// and
/// ?: act lane by lane, and every target has them (those without 512-bit registers take several). The few
/// operations that the language lacks are functions, each with a plain form for every target. What all stages
/// share is here; pack.hpp makes a number type of it, sdpd/simd adds what pairs of particles need.
namespace mesobridge::simd {

inline constexpr std::size_t lane_count = 8;

using Lanes [[gnu::vector_size(64)]] = double;
using FloatLanes [[gnu::vector_size(32)]] = float;
using IntLanes [[gnu::vector_size(32)]] = std::int32_t;
using LongLanes [[gnu::vector_size(64)]] = std::int64_t;

template <class T>
[[gnu::always_inline]] inline T load(void const* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

template <class T>
[[gnu::always_inline]] inline void store(T const& value, void* to) {
  std::memcpy(to, &value, sizeof value);
}

/// The same bits, read as another type.
template <class To, class From>
[[gnu::always_inline]] inline To reinterpret(From const& from) {
  static_assert(sizeof(To) == sizeof(From));
  return load<To>(&from);
}

/// The same number in every lane, in the lanes' precision, or the number itself.
template <class X>
[[gnu::always_inline]] inline X constant(double value) {
  if constexpr (std::is_same_v<X, double>)
    return value;
  else
    return static_cast<std::remove_cvref_t<decltype(X{}[0])>>(value) - X{};
}
[[gnu::always_inline]] inline Lanes broadcast(double value) {
  return constant<Lanes>(value);
}

[[gnu::always_inline]] inline FloatLanes to_float(Lanes const& x) {
  return __builtin_convertvector(x, FloatLanes);
}

[[gnu::always_inline]] inline Lanes to_double(FloatLanes const& x) {
  return __builtin_convertvector(x, Lanes);
}

[[gnu::always_inline]] inline double square_root(double x) {
  return std::sqrt(x);
}

[[gnu::always_inline]] inline Lanes square_root(Lanes const& x) {
#ifdef __AVX512VL__
  return _mm512_maskz_sqrt_pd(0xff, x); // the unmasked one raises a false warning in GCC 12 (its bug 105593)
#else
  Lanes root;
  for (std::size_t l = 0; l < lane_count; ++l)
    root[l] = std::sqrt(x[l]);
  return root;
#endif
}

[[gnu::always_inline]] inline FloatLanes square_root(FloatLanes const& x) {
#ifdef __AVX512VL__
  return _mm256_sqrt_ps(x);
#else
  FloatLanes root;
  for (std::size_t l = 0; l < lane_count; ++l)
    root[l] = std::sqrt(x[l]);
  return root;
#endif
}

} // namespace mesobridge::simd
