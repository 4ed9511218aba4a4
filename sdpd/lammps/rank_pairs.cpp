#include "sdpd/lammps/rank_pairs.hpp"
#include <bit>

namespace mesobridge::sdpd {
namespace {

/// Those of eight candidates that are nearer to the place (x, y, z) than the root of range2.
[[gnu::always_inline]] inline unsigned in_range(Row const* rows, std::uint32_t const* candidates,
                                                Row const& place, double range2) {
  RowLanes const b = load_rows([&](std::size_t l) { return rows + candidates[l]; });
  Lanes const x = place[0] - b[0], y = place[1] - b[1], z = place[2] - b[2];
  return less(x * x + y * y + z * z, broadcast(range2));
}

} // namespace

void RankPairs::find(RankParticles const& particles, std::span<Row const> rows, double range) {
  auto const& list = particles.list;
  std::size_t most = wide_count;
  for (std::size_t k = 0; k < list.first_count; ++k)
    most += static_cast<std::size_t>(list.neighbour_count[list.first[k]]);
  if (room_ < most) {
    room_ = most + most / 8;
    i_ = {}, j_ = {};
    i_ = std::make_unique_for_overwrite<std::uint32_t[]>(room_);
    j_ = std::make_unique_for_overwrite<std::uint32_t[]>(room_);
  }
  double const range2 = range * range;
  std::size_t count = 0;
  for (std::size_t k = 0; k < list.first_count; ++k) {
    auto const i = static_cast<std::uint32_t>(list.first[k]);
    int const* const neighbours = list.neighbours[i];
    auto const candidates = static_cast<std::size_t>(list.neighbour_count[i]);
    for (std::size_t from = 0; from < candidates; from += lane_count) {
      std::size_t const now = std::min(candidates - from, lane_count);
      std::array<std::uint32_t, lane_count> j;
      j.fill(i);
      for (std::size_t l = 0; l < now; ++l)
        j[l] = static_cast<std::uint32_t>(neighbours[from + l] & list.mask);
      unsigned const near = in_range(rows.data(), j.data(), rows[i], range2) & ((1u << now) - 1);
      std::array<std::uint32_t, lane_count> first;
      first.fill(i);
      compress(near, j.data(), &j_[count]);
      std::copy(first.begin(), first.end(), &i_[count]);
      count += static_cast<std::size_t>(std::popcount(near));
    }
  }
  count_ = count;
  for (std::size_t l = count; l % wide_count != 0; ++l)
    i_[l] = i_[count - 1], j_[l] = j_[count - 1];
}

} // namespace mesobridge::sdpd
