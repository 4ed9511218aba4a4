#pragma once
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/neighbours/for_each_block.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Eight pairs of a block, as the law between them sees them: r_ij = q_i - q_j = (x, y, z), its square and
/// length, and what was gathered of both particles. Lanes past `count` hold the phantom pair.
struct PairLanes {
  LocalPair const* pair;
  std::size_t count;
  Lanes x, y, z, r2, r, inverse_r;
  Lanes of_i, of_j;
};

/// What a pair law needs of the particles beside their positions: quantity(i), a number each, and how far
/// apart the phantom pair is that fills lanes (within the range of kernels, beyond that of potentials).
template <class Quantity>
struct Gather {
  Quantity quantity;
  double phantom_distance;
};

/// Nothing beside the positions.
inline constexpr auto no_quantity = [](Index) { return 0.0; };

/// Adds what a law returns, a strength, as the vector strength * r_ij to the first particle of the pair and
/// takes it from the second.
struct EqualAndOpposite {
  using Sums = std::vector<Row>;
  std::vector<Vec3>& values;

  [[gnu::always_inline]] static void add(Row* sums, PairLanes const& at, Lanes const& strength) {
    auto const vectors = to_rows({strength * at.x, strength * at.y, strength * at.z, Lanes{}});
    for (std::size_t l = 0; l < lane_count; ++l) {
      sums[at.pair[l].i] += vectors[l];
      sums[at.pair[l].j] -= vectors[l];
    }
  }
  void give(Index i, Row const& sum) const { values[i] += Vec3{sum[0], sum[1], sum[2]}; }
};

/// Adds the number that a law returns to both particles of the pair.
struct SameToBoth {
  using Sums = std::vector<double>;
  std::vector<double>& values;

  [[gnu::always_inline]] static void add(double* sums, PairLanes const& at, Lanes const& value) {
    for (std::size_t l = 0; l < lane_count; ++l) {
      sums[at.pair[l].i] += value[l];
      sums[at.pair[l].j] += value[l];
    }
  }
  void give(Index i, double sum) const { values[i] += sum; }
};

/// Gives the particles nothing: the law itself keeps what it finds.
struct ToNobody {
  using Sums = std::vector<char>;

  [[gnu::always_inline]] static void add(char*, PairLanes const&, Lanes const&) {}
  void give(Index, char) const {}
};

/// Calls law(pairs, eight at a time) for the pairs of a block whose particles are in `rows`, and adds what it
/// returns to the sums of its particles.
template <class Scatter, class Law>
void sum_over_pairs(std::vector<Row> const& rows, std::span<LocalPair const> pairs, Law& law,
                    typename Scatter::Sums& sums) {
  std::size_t const particles = rows.size() - 2;
  sums.assign(particles + 2, typename Scatter::Sums::value_type{}); // room for the phantom pair
  Row const* const at = rows.data();
  auto* const of = sums.data();
  for_each_group(pairs, particles, [&](LocalPair const* pair, std::size_t, std::size_t count) {
    RowLanes const a = load_rows([&](std::size_t l) { return &at[pair[l].i]; });
    RowLanes const b = load_rows([&](std::size_t l) { return &at[pair[l].j]; });
    Lanes const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], r2 = x * x + y * y + z * z;
    DistanceLanes const distance(r2);
    PairLanes const lanes{pair, count, x, y, z, r2, distance.r, distance.inverse_r, a[3], b[3]};
    Scatter::add(of, lanes, law(lanes));
  });
}

/// The pair loop: for every pair in range the law's result goes to both particles. Each block has a law of
/// its own, make_law(block), which may count along and is given to finish(block, law) at the end.
/// `prepare(block, rows)` comes before the block's pairs are read. The order of the sums does not depend on
/// the threads.
template <class Quantity, class Scatter, class Prepare, class MakeLaw, class Finish>
void for_each_pair(System const& system, Gather<Quantity> const& gather, Scatter const& scatter,
                   Prepare const& prepare, MakeLaw const& make_law, Finish const& finish) {
  auto const& neighbours = system.neighbours;
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local std::vector<Row> rows;
    thread_local typename Scatter::Sums sums;
    auto const members = neighbours.members(block);
    copy_rows(members, system.particles.q, gather.quantity, gather.phantom_distance, rows);
    prepare(block, rows);
    auto law = make_law(block);
    sum_over_pairs<Scatter>(rows, neighbours.pairs(block), law, sums);
    finish(block, law);
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) { scatter.give(i, sums[local]); });
  });
}

/// Where nothing has to be prepared.
inline constexpr auto as_they_are = [](std::size_t, std::vector<Row> const&) {};

} // namespace mesobridge::sdpd
