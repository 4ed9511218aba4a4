#include "sdpd/step/select_pairs.hpp"
#include <bit>

namespace mesobridge::sdpd {
namespace {

/// Where the matchings of the pairs in range end, from where those of the candidates end.
void set_pair_ends(std::span<std::uint32_t const> candidate_ends, SelectionScratch const& scratch,
                   std::span<std::uint32_t> pair_ends) {
  for (std::size_t m = 0; m < pair_ends.size(); ++m) {
    std::size_t const group = candidate_ends[m] / lane_count, lane = candidate_ends[m] % lane_count;
    unsigned const earlier = scratch.bits[group] & ((1u << lane) - 1);
    pair_ends[m] = scratch.before[group] + static_cast<std::uint32_t>(std::popcount(earlier));
  }
}

} // namespace

std::size_t select_pairs(Neighbours& neighbours, std::size_t block, std::vector<Row> const& rows,
                         SelectionScratch& scratch) {
  auto const candidates = neighbours.candidates(block);
  std::size_t const groups = candidates.size() / lane_count + 1;
  scratch.r2.resize(candidates.size() + lane_count);
  scratch.before.resize(groups), scratch.bits.assign(groups, 0);
  Lanes const range2 = broadcast(neighbours.range() * neighbours.range());
  LocalPair* const room = neighbours.pair_room(block).data();
  std::size_t count = 0;
  for_each_group(candidates, rows.size() - 2, [&](LocalPair const* pair, std::size_t first, std::size_t) {
    RowLanes const a = load_rows([&](std::size_t l) { return &rows[pair[l].i]; });
    RowLanes const b = load_rows([&](std::size_t l) { return &rows[pair[l].j]; });
    Lanes const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], r2 = x * x + y * y + z * z;
    unsigned const bits = less(r2, range2);
    compress(bits, pair, room + count);
    compress(bits, r2, &scratch.r2[count]);
    scratch.before[first / lane_count] = static_cast<std::uint32_t>(count);
    scratch.bits[first / lane_count] = static_cast<std::uint8_t>(bits);
    count += static_cast<std::size_t>(std::popcount(bits));
  });
  if (candidates.size() % lane_count == 0) // the group after the last, where the last matching ends
    scratch.before[groups - 1] = static_cast<std::uint32_t>(count);
  neighbours.set_pair_count(block, count);
  set_pair_ends(neighbours.candidate_ends(block), scratch, neighbours.pair_ends(block));
  return count;
}

} // namespace mesobridge::sdpd
