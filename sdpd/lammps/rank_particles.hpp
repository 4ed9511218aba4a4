#pragma once
#include "sdpd/simd/wide_lanes.hpp"
#include <array>
#include <cstdint>
#include <span>

namespace mesobridge::sdpd {

/// The particles that one rank sees: its own first, then the ghosts, which are other ranks' particles and
/// periodic images near its part of the box. Rows of three numbers, reduced; velocities are momenta, because
/// masses are one.
struct RankParticles {
  std::size_t owned, all;
  double const* q;
  double *v, *f;
  std::int32_t const* ids; ///< from 1
  /// Half list of pairs, each once over all ranks: the neighbours of each of `first_count` own particles.
  struct HalfList {
    std::size_t first_count;
    int const *first, *neighbour_count;
    int const* const* neighbours;
    int mask; ///< the bits of a neighbour that are its number
  } list;

  std::uint32_t id(std::size_t i) const { return static_cast<std::uint32_t>(ids[i]) - 1; }
};

/// Brings numbers of the particles from their owners to the ghosts and back; all ranks call it together.
class GhostExchange {
 public:
  virtual ~GhostExchange() = default;
  /// The ghosts' rows of `width` numbers become those of their owners.
  virtual void forward(double* rows, int width) = 0;
  /// The ghosts' rows are added to those of their owners.
  virtual void reverse(double* rows, int width) = 0;
};

/// Sixteen pairs in range, or fewer in the last group, whose other places repeat the first pair.
struct SixteenPairs {
  std::array<std::uint32_t, wide_count> i, j;
  std::array<double, wide_count> x, y, z; ///< q_i - q_j
  std::size_t count = 0;

  void repeat_first() {
    for (std::size_t l = count; l < wide_count; ++l)
      i[l] = i[0], j[l] = j[0], x[l] = x[0], y[l] = y[0], z[l] = z[0];
  }
};

/// Eight of them: the half with the pairs `from`, from + 1 ...
struct EightPairs {
  std::uint32_t const *i, *j;
  std::size_t count;
  Lanes x, y, z, r2, r, inverse_r;

  [[gnu::always_inline]] EightPairs(SixteenPairs const& of, std::size_t from)
      : i(&of.i[from]), j(&of.j[from]), count(of.count < from + lane_count ? of.count - from : lane_count),
        x(load<Lanes>(&of.x[from])), y(load<Lanes>(&of.y[from])), z(load<Lanes>(&of.z[from])),
        r2(x * x + y * y + z * z) {
    DistanceLanes const distance(r2);
    r = distance.r, inverse_r = distance.inverse_r;
  }
};

/// One number of each particle of eight, from rows of `width` numbers.
[[gnu::always_inline]] inline Lanes gather_column(double const* rows, std::size_t width, std::size_t column,
                                                  std::uint32_t const* of) {
  Lanes values;
  for (std::size_t l = 0; l < lane_count; ++l)
    values[l] = rows[of[l] * width + column];
  return values;
}

/// Calls f(sixteen pairs) for all pairs of the list that are nearer than `range`.
template <class F>
void for_each_sixteen(RankParticles const& particles, double range, F const& f) {
  SixteenPairs group;
  double const range2 = range * range;
  double const* const q = particles.q;
  auto const& list = particles.list;
  for (std::size_t k = 0; k < list.first_count; ++k) {
    int const i = list.first[k];
    int const* const neighbours = list.neighbours[i];
    for (int m = 0; m < list.neighbour_count[i]; ++m) {
      int const j = neighbours[m] & list.mask;
      double const x = q[3 * i] - q[3 * j], y = q[3 * i + 1] - q[3 * j + 1], z = q[3 * i + 2] - q[3 * j + 2];
      if (!(x * x + y * y + z * z < range2))
        continue;
      std::size_t const at = group.count++;
      group.i[at] = static_cast<std::uint32_t>(i), group.j[at] = static_cast<std::uint32_t>(j);
      group.x[at] = x, group.y[at] = y, group.z[at] = z;
      if (group.count == wide_count)
        f(group), group.count = 0;
    }
  }
  if (group.count > 0)
    group.repeat_first(), f(group);
}

/// Calls f(eight pairs) for all of them.
template <class F>
void for_each_eight(std::span<SixteenPairs const> pairs, F const& f) {
  for (auto const& group : pairs)
    for (std::size_t from = 0; from < group.count; from += lane_count)
      f(EightPairs(group, from));
}

/// Adds (x, y, z) to the first particle of each pair and takes it from the second.
[[gnu::always_inline]] inline void add_opposite(double* rows, EightPairs const& at, Lanes const& x,
                                                Lanes const& y, Lanes const& z) {
  for (std::size_t l = 0; l < at.count; ++l) {
    double *const a = rows + 3 * std::size_t{at.i[l]}, *const b = rows + 3 * std::size_t{at.j[l]};
    a[0] += x[l], a[1] += y[l], a[2] += z[l];
    b[0] -= x[l], b[1] -= y[l], b[2] -= z[l];
  }
}

} // namespace mesobridge::sdpd
