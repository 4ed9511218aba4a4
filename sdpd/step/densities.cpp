#include "sdpd/block_copy.hpp"
#include "sdpd/for_each_block.hpp"
#include "sdpd/step/conservative.hpp"
#include <bit>

namespace mesobridge::sdpd {
namespace {

struct Scratch {
  std::vector<Row> rows;
  std::vector<double> r2, W, rho;
  std::vector<std::uint32_t> before; // pairs in range before each group of candidates
  std::vector<std::uint8_t> bits;    // which of a group are in range
};

/// Where the matchings of the pairs in range end, from where those of the candidates end.
void set_pair_ends(std::span<std::uint32_t const> candidate_ends, Scratch const& scratch,
                   std::span<std::uint32_t> pair_ends) {
  for (std::size_t m = 0; m < pair_ends.size(); ++m) {
    std::size_t const group = candidate_ends[m] / lane_count, lane = candidate_ends[m] % lane_count;
    unsigned const earlier = scratch.bits[group] & ((1u << lane) - 1);
    pair_ends[m] = scratch.before[group] + static_cast<std::uint32_t>(std::popcount(earlier));
  }
}

/// Picks the pairs in range with their |r|^2. Returns how many there are.
std::size_t select_pairs(Neighbours& neighbours, std::size_t block, std::size_t particles, Scratch& scratch) {
  auto const candidates = neighbours.candidates(block);
  std::size_t const groups = candidates.size() / lane_count + 1;
  scratch.r2.resize(candidates.size() + lane_count);
  scratch.before.resize(groups), scratch.bits.assign(groups, 0);
  Lanes const range2 = broadcast(neighbours.range() * neighbours.range());
  Row const* const rows = scratch.rows.data();
  LocalPair* const room = neighbours.pair_room(block).data();
  std::size_t count = 0;
  for_each_group(candidates, particles, [&](LocalPair const* pair, std::size_t first, std::size_t) {
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

template <class Kernel>
void add_densities(Kernel const& kernel, std::span<LocalPair const> pairs, std::size_t particles,
                   Scratch& scratch) {
  std::size_t const count = pairs.size();
  scratch.W.resize(count + lane_count);
  for (std::size_t k = 0; k < count; k += lane_count)
    store(kernel.W(DistanceLanes(load<Lanes>(&scratch.r2[k])).r), &scratch.W[k]);
  scratch.rho.assign(particles, 0);
  double* const rho = scratch.rho.data();
  for (std::size_t k = 0; k < count; ++k) {
    rho[pairs[k].i] += scratch.W[k];
    rho[pairs[k].j] += scratch.W[k];
  }
}

template <class Kernel>
void find_pairs_and_densities(System& system, Kernel const& kernel) {
  auto& particles = system.particles;
  auto& neighbours = system.neighbours;
  double const out_of_range = 2 * neighbours.range();
  std::fill(particles.rho.begin(), particles.rho.end(), system.self_density);
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local Scratch scratch;
    auto const members = neighbours.members(block);
    std::size_t const n = size(members);
    copy_rows(
        members, particles.q, [](Index) { return 0.0; }, out_of_range, scratch.rows);
    select_pairs(neighbours, block, n, scratch);
    add_densities(kernel, neighbours.pairs(block), n, scratch);
    for_each_member(members,
                    [&](std::size_t local, Index i, Vec3 const&) { particles.rho[i] += scratch.rho[local]; });
  });
}

} // namespace

void find_pairs_and_densities(System& system) {
  std::visit([&](auto const& kernel) { find_pairs_and_densities(system, kernel); }, system.kernel);
}

} // namespace mesobridge::sdpd
