#pragma once
#include "sdpd/cells.hpp"
#include <optional>

namespace mesobridge::sdpd {

/// Two particles that may come within the interaction's range before the lists are renewed.
struct Candidate {
  Index i, j;
};

/// Two particles within the range now: r = q_i - q_j of the nearest image, and the kernel's F(|r|).
struct Pair {
  Index i, j;
  Vec3 r;
  double F;
};

/// Lists of pairs by cell pair. Candidates are found when the lists are renewed; the pairs in range are
/// picked from them each time that the particles have moved. Within a cell pair the order runs along
/// diagonals, (0,0) (1,1) ... (0,1) (1,2) ..., so that a pair shares no particle with the next: a processor
/// can then overlap them. Which pairs there are, and their order, depends on the positions at the last
/// renewal and now, on nothing else.
class Neighbours {
 public:
  Neighbours(Box box, double range, double skin, int threads);

  double range() const { return range_; }
  CellGrid const& grid() const { return grid_; }

  /// True when some particle has moved by more than half the skin since the last renewal (or there was none).
  bool outdated(std::span<Vec3 const> q) const;

  /// Wraps the particles into the box, sorts them by (cell, id) and finds the candidates.
  void renew(Particles& particles);

  /// Positions at the last renewal, in today's order: with them a restart renews the same lists.
  std::span<Vec3 const> positions_at_renewal() const { return q_renewed_; }

  std::span<Candidate const> candidates(std::size_t task) const { return candidates_[task]; }
  Vec3 const& shift(std::size_t task) const { return grid_.pairs()[task].shift; }

  /// Room for the pairs in range of one cell pair; `pair_count` says how much of it is in use.
  std::span<Pair> room(std::size_t task) {
    return {pairs_.data() + room_begin_[task], candidates_[task].size()};
  }
  std::span<Pair const> pairs(std::size_t task) const {
    return {pairs_.data() + room_begin_[task], pair_count_[task]};
  }
  std::span<Pair> pairs(std::size_t task) { return {pairs_.data() + room_begin_[task], pair_count_[task]}; }
  void set_pair_count(std::size_t task, std::size_t count) { pair_count_[task] = count; }
  std::size_t pair_count() const;

 private:
  void sort(Particles& particles);
  void find_candidates(std::size_t task, std::span<Vec3 const> q);

  Box box_;
  double range_, skin_;
  int threads_;
  CellGrid grid_;
  std::vector<Index> cell_begin_;
  std::vector<Vec3> q_renewed_;
  std::vector<std::vector<Candidate>> candidates_;
  std::vector<std::size_t> room_begin_, pair_count_;
  std::vector<Pair> pairs_;
};

/// Calls f(task) for every cell pair of the grid, phase after phase, on all threads. Only for functions that
/// write to the particles of their own two cells.
template <class F>
void for_each_task(CellGrid const& grid, int threads, F&& f) {
  auto const begin = grid.phase_begin();
#pragma omp parallel num_threads(threads)
  for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
#pragma omp for schedule(static)
    for (std::size_t task = begin[phase]; task < begin[phase + 1]; ++task)
      f(task);
  }
}

} // namespace mesobridge::sdpd
