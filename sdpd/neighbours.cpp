#include "sdpd/neighbours.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

template <class T>
void reorder(std::vector<T>& values, std::span<Index const> order, int threads) {
  std::vector<T> sorted(values.size());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t k = 0; k < order.size(); ++k)
    sorted[k] = values[order[k]];
  values.swap(sorted);
}

} // namespace

Neighbours::Neighbours(Box box, double range, double skin, int threads)
    : box_(box), range_(range), skin_(skin), threads_(threads), grid_(box, range + skin),
      candidates_(grid_.pairs().size()), room_begin_(grid_.pairs().size()),
      pair_count_(grid_.pairs().size()) {}

bool Neighbours::outdated(std::span<Vec3 const> q) const {
  if (q_renewed_.empty())
    return true;
  double const allowed = skin_ * skin_ / 4;
  bool far = false;
#pragma omp parallel for schedule(static) num_threads(threads_) reduction(|| : far)
  for (std::size_t i = 0; i < q.size(); ++i)
    far = far || !(norm2(q[i] - q_renewed_[i]) <= allowed);
  return far;
}

void Neighbours::renew(Particles& particles) {
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.q[i] = box_.wrap(particles.q[i]);
  sort(particles);
  q_renewed_ = particles.q;
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads_)
  for (std::size_t task = 0; task < candidates_.size(); ++task)
    find_candidates(task, particles.q);
  std::size_t total = 0;
  for (std::size_t task = 0; task < candidates_.size(); ++task) {
    room_begin_[task] = total;
    total += candidates_[task].size();
  }
  i_.resize(total), j_.resize(total), x_.resize(total), y_.resize(total), z_.resize(total), F_.resize(total);
  std::fill(pair_count_.begin(), pair_count_.end(), 0);
}

void Neighbours::sort(Particles& particles) {
  std::vector<Index> cell(particles.size()), order(particles.size());
  cell_begin_.assign(grid_.cell_count() + 1, 0);
  for (std::size_t i = 0; i < particles.size(); ++i)
    ++cell_begin_[(cell[i] = grid_.cell_of(particles.q[i])) + 1];
  std::partial_sum(cell_begin_.begin(), cell_begin_.end(), cell_begin_.begin());
  std::vector<Index> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (std::size_t i = 0; i < particles.size(); ++i)
    order[next[cell[i]]++] = static_cast<Index>(i);
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t c = 0; c < grid_.cell_count(); ++c)
    std::sort(order.begin() + cell_begin_[c], order.begin() + cell_begin_[c + 1],
              [&](Index a, Index b) { return particles.id[a] < particles.id[b]; });
  auto each = [&](auto&... values) { (reorder(values, order, threads_), ...); };
  each(particles.id, particles.q, particles.p, particles.eps, particles.rho, particles.S, particles.T,
       particles.P, particles.f, particles.caloric);
}

void Neighbours::find_candidates(std::size_t task, std::span<Vec3 const> q) {
  auto const& [first, second, shift] = grid_.pairs()[task];
  double const reach = (range_ + skin_) * (range_ + skin_);
  Index const a = cell_begin_[first], b = cell_begin_[second];
  Index const n_a = cell_begin_[first + 1] - a, n_b = cell_begin_[second + 1] - b;
  thread_local std::vector<Candidate> found;
  if (std::size_t const room = std::size_t{n_a} * n_b + 1; found.size() < room)
    found.resize(room);
  std::size_t count = 0;
  auto consider = [&](Index i, Index j) { // without a branch: what is too far is overwritten by the next
    found[count] = {i, j};
    count += norm2(q[i] - q[j] - shift) < reach;
  };
  if (first == second) {
    for (Index k = 1; 2 * k <= n_a; ++k)
      for (Index i = 0; i < (2 * k == n_a ? k : n_a); ++i)
        consider(a + i, a + (i + k < n_a ? i + k : i + k - n_a));
  } else if (n_a <= n_b) {
    for (Index k = 0; k < n_b; ++k)
      for (Index i = 0; i < n_a; ++i)
        consider(a + i, b + (i + k < n_b ? i + k : i + k - n_b));
  } else {
    for (Index k = 0; k < n_a; ++k)
      for (Index j = 0; j < n_b; ++j)
        consider(a + (j + k < n_a ? j + k : j + k - n_a), b + j);
  }
  candidates_[task].assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
}

std::size_t Neighbours::pair_count() const {
  return std::accumulate(pair_count_.begin(), pair_count_.end(), std::size_t{0});
}

} // namespace mesobridge::sdpd
