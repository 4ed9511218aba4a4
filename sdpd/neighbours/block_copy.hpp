#pragma once
#include "sdpd/neighbours/neighbours.hpp"
#include "sdpd/simd/wide_lanes.hpp"

namespace mesobridge::sdpd {

/// Calls f(local, global, shift) for the particles of a block.
template <class F>
void for_each_member(BlockMembers const& members, F&& f) {
  std::size_t local = 0;
  for (auto const& cell : members)
    for (Index i = cell.begin; i < cell.end; ++i, ++local)
      f(local, i, cell.shift);
}

/// Positions of a block's particles with one more quantity each, as rows; those of single precision relative
/// to the first particle. Two places follow the last particle: a pair of phantoms with the quantity 0 at
/// distance `apart`, which fill the lanes that a number of pairs leaves over.
template <class AnyRow, class Quantity>
void copy_rows(BlockMembers const& members, std::span<Vec3 const> q, Quantity const& quantity, double apart,
               std::vector<AnyRow>& rows) {
  std::size_t const n = size(members);
  rows.resize(n + 2);
  Vec3 origin;
  for_each_member(members, [&](std::size_t local, Index i, Vec3 const& shift) {
    if constexpr (std::is_same_v<AnyRow, FloatRow>)
      if (local == 0)
        origin = q[i] + shift;
    Vec3 const to_place = shift - origin;
    rows[local] = __builtin_convertvector(
        (Row{q[i].x + to_place.x, q[i].y + to_place.y, q[i].z + to_place.z, quantity(i)}), AnyRow);
  });
  rows[n] = AnyRow{};
  rows[n + 1] = __builtin_convertvector((Row{apart, 0, 0, 0}), AnyRow);
}

/// Rows in single precision, with the positions relative to the first one's. The phantoms stay where they
/// are: as far away as particles can be, single precision would bring them together.
inline void round_rows(std::vector<Row> const& rows, std::vector<FloatRow>& rounded) {
  Row const origin{rows[0][0], rows[0][1], rows[0][2], 0};
  rounded.resize(rows.size());
  std::size_t const particles = rows.size() - 2;
  for (std::size_t k = 0; k < rows.size(); ++k)
    rounded[k] = __builtin_convertvector(k < particles ? rows[k] - origin : rows[k], FloatRow);
}

/// A list of pairs in groups of `length`: calls f(pairs, first, count) with a pointer to that many pairs, the
/// number of the first in the list and how many of them are in it; the others are the phantom pair.
template <std::size_t length = lane_count, class F>
[[gnu::always_inline]] inline void for_each_group(std::span<LocalPair const> pairs, std::size_t particles,
                                                  F&& f) {
  std::size_t k = 0;
  for (; k + length <= pairs.size(); k += length)
    f(&pairs[k], k, length);
  if (k == pairs.size())
    return;
  std::array<LocalPair, length> last;
  last.fill({static_cast<std::uint16_t>(particles), static_cast<std::uint16_t>(particles + 1)});
  std::copy(pairs.begin() + static_cast<std::ptrdiff_t>(k), pairs.end(), last.begin());
  f(last.data(), k, pairs.size() - k);
}

} // namespace mesobridge::sdpd
