#pragma once
#include "sdpd/neighbours/neighbours.hpp"
#include "sdpd/simd/lanes.hpp"
#include <bit>

namespace mesobridge::sdpd {

/// A number of the first and of the second particle of eight pairs.
struct PairValues {
  Lanes i, j;
};

/// Reads them from the numbers of a block's particles. Lanes that are filled one by one would pass through
/// memory, and reading eight numbers just after they were written two at a time takes as long as half a law.
[[gnu::always_inline]] inline PairValues values_of(double const* values, LocalPair const* pair) {
#ifdef __AVX512VL__
  static_assert(sizeof(LocalPair) == sizeof(std::int32_t) && std::endian::native == std::endian::little);
  auto const places = load<__m256i>(pair); // i in the lower half of each word, j in the upper one
  auto read = [&](__m256i const& place) {
    return Lanes(_mm512_mask_i32gather_pd(_mm512_setzero_pd(), 0xff, place, values, sizeof *values));
  };
  return {read(_mm256_and_si256(places, _mm256_set1_epi32(0xffff))), read(_mm256_srli_epi32(places, 16))};
#else
  PairValues of{};
  for (std::size_t l = 0; l < lane_count; ++l)
    of.i[l] = values[pair[l].i], of.j[l] = values[pair[l].j];
  return of;
#endif
}

} // namespace mesobridge::sdpd
