#pragma once
#include "sdpd/friction/bath.hpp"
#include "sdpd/lammps/rank_particles.hpp"
#include "sdpd/simd/wide_lanes.hpp"
#include <memory>
#include <span>
#include <vector>

namespace mesobridge::sdpd {

/// Pairs of a rank's particles that are in range, those with one first particle together.
class RankPairs {
 public:
  /// Finds them in the particles' list; `rows` hold the positions of all particles.
  void find(RankParticles const& particles, std::span<Row const> rows, double range);

  /// Calls f(i, j, count) with the numbers of sixteen pairs' particles, of which the first `count` are meant;
  /// the others repeat the last pair.
  template <class F>
  void for_each_sixteen(F const& f) const {
    for (std::size_t k = 0; k < count_; k += wide_count)
      f(&i_[k], &j_[k], std::min(count_ - k, wide_count));
  }

 private:
  /// Without values until pairs are found: pages that no pair reaches take no memory.
  using Numbers = std::unique_ptr<std::uint32_t[]>;
  Numbers i_, j_;         ///< with room for a last group
  std::size_t room_ = 0;  ///< of each
  std::size_t count_ = 0; ///< in use
};

/// Whether eight pairs, the numbers of whose first particles these are, have one first particle.
[[gnu::always_inline]] inline bool are_one(std::uint32_t const* i) {
  return i[0] == i[lane_count - 1];
}

/// The rows of the first particles of eight pairs.
[[gnu::always_inline]] inline RowLanes first_rows(Row const* rows, std::uint32_t const* i) {
  if (!are_one(i))
    return load_rows([&](std::size_t l) { return rows + i[l]; });
  Row const& row = rows[i[0]];
  return {broadcast(row[0]), broadcast(row[1]), broadcast(row[2]), broadcast(row[3])};
}

/// Eight pairs of them: r_ij = q_i - q_j = (x, y, z), its square and length, and the fourth numbers of the
/// rows of both particles.
struct EightPairs {
  std::uint32_t const *i, *j;
  std::size_t count;
  Lanes x, y, z, r2, r, inverse_r, of_i, of_j;

  [[gnu::always_inline]] EightPairs(Row const* rows, std::uint32_t const* first, std::uint32_t const* second,
                                    std::size_t number)
      : i(first), j(second), count(std::min(number, lane_count)) {
    RowLanes const a = first_rows(rows, first);
    RowLanes const b = load_rows([&](std::size_t l) { return rows + second[l]; });
    x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], of_i = a[3], of_j = b[3];
    r2 = x * x + y * y + z * z;
    DistanceLanes const distance(r2);
    r = distance.r, inverse_r = distance.inverse_r;
  }
  /// Whether they are all of one first particle.
  bool of_one() const { return are_one(i) && count == lane_count; }
};

/// A distance beside the range may round past it, where some kernels are below zero.
[[gnu::always_inline]] inline PairWeights<Lanes> not_negative(PairWeights<Lanes> const& weight) {
  Lanes const zero{};
  return {weight.par < zero ? zero : weight.par, weight.perp < zero ? zero : weight.perp};
}

/// Calls f(eight pairs) for all of them.
template <class F>
void for_each_eight(RankPairs const& pairs, std::span<Row const> rows, F const& f) {
  pairs.for_each_sixteen([&](std::uint32_t const* i, std::uint32_t const* j, std::size_t count) {
    for (std::size_t from = 0; from < count; from += lane_count)
      f(EightPairs(rows.data(), i + from, j + from, count - from));
  });
}

/// Adds (x, y, z) to the row of the first particle of each pair and takes it from the second's.
[[gnu::always_inline]] inline void add_opposite(std::span<Row> sums, EightPairs const& at, Lanes const& x,
                                                Lanes const& y, Lanes const& z) {
  auto const rows = to_rows({x, y, z, Lanes{}});
  if (at.of_one()) {
    for (std::size_t l = 0; l < lane_count; ++l)
      sums[at.j[l]] -= rows[l];
    sums[at.i[0]] +=
        ((rows[0] + rows[1]) + (rows[2] + rows[3])) + ((rows[4] + rows[5]) + (rows[6] + rows[7]));
    return;
  }
  for (std::size_t l = 0; l < at.count; ++l)
    sums[at.i[l]] += rows[l], sums[at.j[l]] -= rows[l];
}

/// Adds a number to both particles of each pair.
[[gnu::always_inline]] inline void add_to_both(std::span<double> sums, EightPairs const& at,
                                               Lanes const& value) {
  if (at.of_one()) {
    for (std::size_t l = 0; l < lane_count; ++l)
      sums[at.j[l]] += value[l];
    sums[at.i[0]] += sum(value);
    return;
  }
  for (std::size_t l = 0; l < at.count; ++l)
    sums[at.i[l]] += value[l], sums[at.j[l]] += value[l];
}

} // namespace mesobridge::sdpd
