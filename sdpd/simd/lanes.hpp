#pragma once
#include "fitting/simd/lanes.hpp"
#include <array>

/// Eight numbers of as many pairs of particles.
namespace mesobridge::sdpd {

using simd::lane_count, simd::Lanes, simd::FloatLanes, simd::IntLanes, simd::LongLanes;
using simd::load, simd::store, simd::reinterpret, simd::constant, simd::broadcast, simd::to_float,
    simd::to_double, simd::square_root;

/// Four numbers of one particle, in half a cache line.
using Row [[gnu::vector_size(32)]] = double;

inline double sum(Lanes const& lanes) {
  double total = 0;
  for (std::size_t l = 0; l < lane_count; ++l)
    total += lanes[l];
  return total;
}

/// 1/sqrt(x) for x >= 1e-290, to 2 units in the last place.
[[gnu::always_inline]] inline Lanes inverse_square_root(Lanes const& x) {
#ifdef __AVX512VL__
  Lanes y = _mm512_maskz_rsqrt14_pd(0xff, x); // right to 2^-14; Newton's iteration doubles the digits
  y *= 1.5 - 0.5 * x * y * y;
  y *= 1.5 - 0.5 * x * y * y;
  return y;
#else
  return 1.0 / square_root(x);
#endif
}

/// Bit l is set where a < b in lane l.
[[gnu::always_inline]] inline unsigned less(Lanes const& a, Lanes const& b) {
#ifdef __AVX512VL__
  return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
#else
  unsigned bits = 0;
  for (std::size_t l = 0; l < lane_count; ++l)
    bits |= unsigned{a[l] < b[l]} << l;
  return bits;
#endif
}

/// Writes the lanes whose bits are set to `to`, close together; writes past them, up to lane_count values.
[[gnu::always_inline]] inline void compress(unsigned bits, Lanes const& values, double* to) {
#ifdef __AVX512VL__
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), values));
#else
  std::size_t count = 0;
  for (std::size_t l = 0; l < lane_count; ++l) {
    to[count] = values[l];
    count += bits >> l & 1u;
  }
#endif
}

/// The same for eight values of 32 bits each.
template <class T>
[[gnu::always_inline]] inline void compress(unsigned bits, T const* values, T* to) {
  static_assert(sizeof(T) == 4);
#ifdef __AVX512VL__
  __m256i const loaded = load<__m256i>(values);
  store(_mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), loaded), to);
#else
  std::array<T, lane_count> copy; // `to` may overlap `values`
  std::memcpy(copy.data(), values, sizeof copy);
  std::size_t count = 0;
  for (std::size_t l = 0; l < lane_count; ++l) {
    to[count] = copy[l];
    count += bits >> l & 1u;
  }
#endif
}

/// values[index[l]] lane by lane.
[[gnu::always_inline]] inline Lanes gather(double const* values, std::uint32_t const* index) {
  return Lanes{values[index[0]], values[index[1]], values[index[2]], values[index[3]],
               values[index[4]], values[index[5]], values[index[6]], values[index[7]]};
}

/// Four quantities of eight particles: quantity[k][l] belongs to the particle of lane l.
using RowLanes = std::array<Lanes, 4>;
/// Eight quantities of eight particles.
using LineLanes = std::array<Lanes, 8>;

namespace detail {

[[gnu::always_inline]] inline Lanes join(Row const& low, Row const& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
/// The even (odd) numbers of a and b, alternating: step one of a transposition.
[[gnu::always_inline]] inline Lanes evens(Lanes const& a, Lanes const& b) {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
[[gnu::always_inline]] inline Lanes odds(Lanes const& a, Lanes const& b) {
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
/// The even (odd) pairs of numbers of a and b, alternating: step two.
[[gnu::always_inline]] inline Lanes even_pairs(Lanes const& a, Lanes const& b) {
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
[[gnu::always_inline]] inline Lanes odd_pairs(Lanes const& a, Lanes const& b) {
  return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}
[[gnu::always_inline]] inline Lanes low_halves(Lanes const& a, Lanes const& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
}
[[gnu::always_inline]] inline Lanes high_halves(Lanes const& a, Lanes const& b) {
  return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
}
[[gnu::always_inline]] inline Row low_half(Lanes const& a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3);
}
[[gnu::always_inline]] inline Row high_half(Lanes const& a) {
  return __builtin_shufflevector(a, a, 4, 5, 6, 7);
}

} // namespace detail

/// Reads the row at row_of(l) for each lane l and turns rows into quantities.
template <class RowOf>
[[gnu::always_inline]] inline RowLanes load_rows(RowOf const& row_of) {
  using namespace detail;
  auto row = [&](std::size_t l) [[gnu::always_inline]] { return load<Row>(row_of(l)); };
  Lanes const a = join(row(0), row(4)), b = join(row(1), row(5)), c = join(row(2), row(6)),
              d = join(row(3), row(7));
  Lanes const ab_even = evens(a, b), ab_odd = odds(a, b), cd_even = evens(c, d), cd_odd = odds(c, d);
  return {even_pairs(ab_even, cd_even), even_pairs(ab_odd, cd_odd), odd_pairs(ab_even, cd_even),
          odd_pairs(ab_odd, cd_odd)};
}

/// Turns four quantities of eight particles into eight rows.
[[gnu::always_inline]] inline std::array<Row, 8> to_rows(RowLanes const& q) {
  using namespace detail;
  Lanes const even_01 = evens(q[0], q[1]), odd_01 = odds(q[0], q[1]), even_23 = evens(q[2], q[3]),
              odd_23 = odds(q[2], q[3]);
  Lanes const r04 = even_pairs(even_01, even_23), r26 = odd_pairs(even_01, even_23),
              r15 = even_pairs(odd_01, odd_23), r37 = odd_pairs(odd_01, odd_23);
  return {low_half(r04),  low_half(r15),  low_half(r26),  low_half(r37),
          high_half(r04), high_half(r15), high_half(r26), high_half(r37)};
}

/// Reads the line of eight numbers at line_of(l) for each lane l and turns lines into quantities.
template <class LineOf>
[[gnu::always_inline]] inline LineLanes load_lines(LineOf const& line_of) {
  using namespace detail;
  auto line = [&](std::size_t l) [[gnu::always_inline]] { return load<Lanes>(line_of(l)); };
  Lanes const l0 = line(0), l1 = line(1), l2 = line(2), l3 = line(3), l4 = line(4), l5 = line(5),
              l6 = line(6), l7 = line(7);
  Lanes const e01 = evens(l0, l1), o01 = odds(l0, l1), e23 = evens(l2, l3), o23 = odds(l2, l3),
              e45 = evens(l4, l5), o45 = odds(l4, l5), e67 = evens(l6, l7), o67 = odds(l6, l7);
  // Quantities 0 and 4, 1 and 5, 2 and 6, 3 and 7 of four particles each.
  Lanes const a04 = even_pairs(e01, e23), a26 = odd_pairs(e01, e23), a15 = even_pairs(o01, o23),
              a37 = odd_pairs(o01, o23), b04 = even_pairs(e45, e67), b26 = odd_pairs(e45, e67),
              b15 = even_pairs(o45, o67), b37 = odd_pairs(o45, o67);
  return {low_halves(a04, b04),  low_halves(a15, b15),  low_halves(a26, b26),  low_halves(a37, b37),
          high_halves(a04, b04), high_halves(a15, b15), high_halves(a26, b26), high_halves(a37, b37)};
}

} // namespace mesobridge::sdpd
