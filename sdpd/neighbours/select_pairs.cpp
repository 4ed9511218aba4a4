#include "sdpd/neighbours/select_pairs.hpp"
#include <bit>

namespace mesobridge::sdpd {
namespace {

/// Where the matchings of the pairs in range end, from where those of the candidates end.
void set_pair_ends(std::span<std::uint32_t const> candidate_ends, std::size_t width,
                   SelectionScratch const& scratch, std::span<std::uint32_t> pair_ends) {
  for (std::size_t m = 0; m < pair_ends.size(); ++m) {
    std::size_t const group = candidate_ends[m] / width, lane = candidate_ends[m] % width;
    unsigned const earlier = scratch.bits[group] & ((1u << lane) - 1);
    pair_ends[m] = scratch.before[group] + static_cast<std::uint32_t>(std::popcount(earlier));
  }
}

/// Takes the candidates in groups of `width`; those of a group that are in range are the bits of
/// in_range(pairs, number found before).
template <std::size_t width, class InRange>
void select(Neighbours& neighbours, std::size_t block, std::size_t particles, SelectionScratch& scratch,
            InRange const& in_range) {
  auto const candidates = neighbours.candidates(block);
  std::size_t const groups = candidates.size() / width + 1;
  scratch.before.resize(groups), scratch.bits.assign(groups, 0);
  std::size_t count = 0;
  for_each_group<width>(candidates, particles, [&](LocalPair const* pair, std::size_t first, std::size_t) {
    unsigned const bits = in_range(pair, count);
    scratch.before[first / width] = static_cast<std::uint32_t>(count);
    scratch.bits[first / width] = static_cast<std::uint16_t>(bits);
    count += static_cast<std::size_t>(std::popcount(bits));
  });
  if (candidates.size() % width == 0) // the group after the last, where the last matching ends
    scratch.before[groups - 1] = static_cast<std::uint32_t>(count);
  neighbours.set_pair_count(block, count);
  set_pair_ends(neighbours.candidate_ends(block), width, scratch, neighbours.pair_ends(block));
}

} // namespace

void select_pairs_and_distances(Neighbours& neighbours, std::size_t block, std::vector<Row> const& rows,
                                SelectionScratch& scratch) {
  scratch.r2.resize(neighbours.candidates(block).size() + lane_count);
  Lanes const range2 = broadcast(neighbours.range() * neighbours.range());
  LocalPair* const room = neighbours.pair_room(block).data();
  select<lane_count>(
      neighbours, block, rows.size() - 2, scratch, [&](LocalPair const* pair, std::size_t found) {
        RowLanes const a = load_rows([&](std::size_t l) { return &rows[pair[l].i]; });
        RowLanes const b = load_rows([&](std::size_t l) { return &rows[pair[l].j]; });
        Lanes const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], r2 = x * x + y * y + z * z;
        unsigned const bits = less(r2, range2);
        compress(bits, pair, room + found);
        compress(bits, r2, &scratch.r2[found]);
        return bits;
      });
}

void select_pairs(Neighbours& neighbours, std::size_t block, std::vector<FloatRow> const& rows,
                  SelectionScratch& scratch) {
  // Wider by more than single precision errs within a block, which is a few reaches wide.
  double const range = neighbours.range() + 1e-5 * neighbours.reach();
  auto const range2 = constant<WideFloats>(range * range);
  LocalPair* const room = neighbours.pair_room(block).data();
  select<wide_count>(neighbours, block, rows.size() - 2, scratch,
                     [&](LocalPair const* pair, std::size_t found) {
                       auto const a = load_wide_rows([&](std::size_t l) { return &rows[pair[l].i]; });
                       auto const b = load_wide_rows([&](std::size_t l) { return &rows[pair[l].j]; });
                       WideFloats const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
                       unsigned const bits = less(x * x + y * y + z * z, range2);
                       compress(bits, load<WideBits>(pair), room + found);
                       return bits;
                     });
}

} // namespace mesobridge::sdpd
