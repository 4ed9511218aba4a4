#include "sdpd/neighbours.hpp"
#include "md/error.hpp"
#include "sdpd/lanes.hpp"
#include "sdpd/matchings.hpp"
#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <stdexcept>

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

/// The positions of a block's particles, place by place, with room for whole registers past the end.
struct LocalPositions {
  std::vector<double> x, y, z;

  void copy(BlockMembers const& members, std::span<Vec3 const> q) {
    std::size_t const room = size(members) + lane_count;
    x.resize(room), y.resize(room), z.resize(room);
    std::size_t k = 0;
    for (auto const& cell : members)
      for (Index i = cell.begin; i < cell.end; ++i, ++k) {
        Vec3 const moved = q[i] + cell.shift;
        x[k] = moved.x, y[k] = moved.y, z[k] = moved.z;
      }
  }
};

/// Appends the pairs of i with begin ... end-1 that are nearer than the reach.
void append_near(LocalPositions const& at, std::size_t i, std::size_t begin, std::size_t end, double reach2,
                 std::vector<LocalPair>& found, std::size_t& count) {
  if (found.size() < count + (end - begin) + lane_count)
    found.resize(2 * (count + (end - begin) + lane_count));
  Lanes const x = broadcast(at.x[i]), y = broadcast(at.y[i]), z = broadcast(at.z[i]);
  std::array<LocalPair, lane_count> pairs;
  for (std::size_t j = begin; j < end; j += lane_count) {
    Lanes const dx = load<Lanes>(&at.x[j]) - x, dy = load<Lanes>(&at.y[j]) - y,
                dz = load<Lanes>(&at.z[j]) - z;
    unsigned const present = end - j < lane_count ? (1u << (end - j)) - 1 : 0xffu;
    unsigned const bits = less(dx * dx + dy * dy + dz * dz, broadcast(reach2)) & present;
    for (std::size_t l = 0; l < lane_count; ++l)
      pairs[l] = {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j + l)};
    compress(bits, pairs.data(), &found[count]);
    count += static_cast<std::size_t>(std::popcount(bits));
  }
}

} // namespace

Index global_index(BlockMembers const& members, std::size_t local) {
  for (auto const& cell : members) {
    if (local < cell.end - cell.begin)
      return static_cast<Index>(cell.begin + local);
    local -= cell.end - cell.begin;
  }
  throw std::logic_error("no such particle in the block");
}

Neighbours::Neighbours(Box box, double range, double skin, int threads)
    : box_(box), range_(range), skin_(skin), threads_(threads), grid_(box, range + skin),
      lists_(grid_.blocks().size()) {}

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

BlockMembers Neighbours::members(std::size_t block) const {
  auto const& [cell, shift] = grid_.blocks()[block];
  BlockMembers members;
  for (std::size_t c = 0; c < cell.size(); ++c)
    members[c] = {cell_begin_[cell[c]], cell_begin_[cell[c] + 1], shift[c]};
  return members;
}

void Neighbours::renew(Particles& particles) {
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.q[i] = box_.wrap(particles.q[i]);
  sort(particles);
  q_renewed_ = particles.q;
  largest_block_ = 0;
  for (std::size_t block = 0; block < lists_.size(); ++block)
    largest_block_ = std::max(largest_block_, size(members(block)));
  std::size_t const most = std::numeric_limits<std::uint16_t>::max() - 1;
  if (largest_block_ > most)
    throw PhysicsError(
        fmt::format("{} of {} particles crowd into eight neighbouring cells (at most {} can be "
                    "handled): the system has collapsed",
                    largest_block_, particles.size(), most));
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads_)
  for (std::size_t block = 0; block < lists_.size(); ++block)
    find_candidates(block, particles.q);
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

void Neighbours::find_candidates(std::size_t block, std::span<Vec3 const> q) {
  thread_local LocalPositions at;
  thread_local std::vector<LocalPair> found;
  auto const all = members(block);
  at.copy(all, q);
  std::array<std::size_t, 9> begin{};
  for (std::size_t c = 0; c < 8; ++c)
    begin[c + 1] = begin[c] + (all[c].end - all[c].begin);
  double const reach2 = (range_ + skin_) * (range_ + skin_);
  std::size_t count = 0;
  for (auto const& [a, b] : block_cell_pairs)
    for (std::size_t i = begin[a]; i < begin[a + 1]; ++i)
      append_near(at, i, a == b ? i + 1 : begin[b], begin[b + 1], reach2, found, count);
  auto& lists = lists_[block];
  order_in_matchings(std::span(found).first(count), begin[8], lists.candidates, lists.candidate_ends);
  lists.pairs.reserve(count + lane_count); // no more than that: vectors that grow take up to twice as much
  lists.pairs.resize(count + lane_count);
  lists.pair_ends.resize(lists.candidate_ends.size());
  lists.pair_count = 0;
}

std::size_t Neighbours::pair_count() const {
  std::size_t count = 0;
  for (auto const& lists : lists_)
    count += lists.pair_count;
  return count;
}

} // namespace mesobridge::sdpd
