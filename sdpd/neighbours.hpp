#pragma once
#include "sdpd/barrier.hpp"
#include "sdpd/cells.hpp"
#include <omp.h>
#include <optional>

namespace mesobridge::sdpd {

/// Two particles that may come within the interaction's range before the lists are renewed.
struct Candidate {
  Index i, j;
};

/// Pairs of particles within the range now, as a structure of arrays: the separations r = q_i - q_j of the
/// nearest images and the kernel's F(|r|).
struct Pairs {
  std::span<Index> i, j;
  std::span<double> x, y, z, F;

  std::size_t size() const { return i.size(); }
  Vec3 r(std::size_t k) const { return {x[k], y[k], z[k]}; }
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

  /// Room for the pairs in range of one cell pair; set_pair_count says how much of it is in use.
  Pairs room(std::size_t task) { return part(task, candidates_[task].size()); }
  void set_pair_count(std::size_t task, std::size_t count) { pair_count_[task] = count; }
  Pairs pairs(std::size_t task) { return part(task, pair_count_[task]); }
  std::size_t pair_count() const;

 private:
  Pairs part(std::size_t task, std::size_t count) {
    std::size_t const begin = room_begin_[task];
    auto of = [begin, count](auto& array) { return std::span(array).subspan(begin, count); };
    return {of(i_), of(j_), of(x_), of(y_), of(z_), of(F_)};
  }
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
  std::vector<Index> i_, j_;
  std::vector<double> x_, y_, z_, F_;
};

/// Calls f(task) for every cell pair of the grid, phase after phase, on all threads. Only for functions that
/// write to the particles of their own two cells.
template <class F>
void for_each_task(CellGrid const& grid, int threads, F&& f) {
  auto const begin = grid.phase_begin();
  if (threads == 1) { // the phases follow each other in the list
    for (std::size_t task = 0; task < grid.pairs().size(); ++task)
      f(task);
    return;
  }
  std::optional<Barrier> barrier;
#pragma omp parallel num_threads(threads)
  {
#pragma omp single // ends with a barrier of its own: all see the new one
    barrier.emplace(omp_get_num_threads());
    auto const team = static_cast<std::size_t>(omp_get_num_threads());
    auto const me = static_cast<std::size_t>(omp_get_thread_num());
    for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
      std::size_t const first = begin[phase], count = begin[phase + 1] - first;
      for (std::size_t task = first + count * me / team; task < first + count * (me + 1) / team; ++task)
        f(task);
      barrier->wait();
    }
  }
}

} // namespace mesobridge::sdpd
