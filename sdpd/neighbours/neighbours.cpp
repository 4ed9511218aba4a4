#include "sdpd/neighbours/neighbours.hpp"
#include "md/error.hpp"
#include "sdpd/neighbours/for_each_block.hpp"
#include "sdpd/neighbours/matchings.hpp"
#include "sdpd/simd/wide_lanes.hpp"
#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace mesobridge::sdpd {
namespace {

/// Brings the values into that order; `room` is where they are put together.
template <class T>
void reorder(std::vector<T>& values, std::vector<T>& room, std::span<Index const> order, int threads) {
  if (values.empty())
    return; // the method has no such quantity
  room.resize(values.size());
  for_each_index(order.size(), threads, [&](std::size_t k) { room[k] = values[order[k]]; });
  values.swap(room);
}

/// The positions of a block's particles as seen from the first, place by place, with room for whole registers
/// past the end. Single precision does for candidates.
struct LocalPositions {
  std::vector<float> x, y, z;

  void copy(BlockMembers const& members, std::span<Vec3 const> q) {
    std::size_t const room = size(members) + wide_count;
    x.resize(room), y.resize(room), z.resize(room);
    std::optional<Vec3> origin;
    std::size_t k = 0;
    for (auto const& cell : members)
      for (Index i = cell.begin; i < cell.end; ++i, ++k) {
        Vec3 const image = q[i] + cell.shift;
        origin = origin.value_or(image);
        Vec3 const seen = image - *origin;
        x[k] = static_cast<float>(seen.x), y[k] = static_cast<float>(seen.y),
        z[k] = static_cast<float>(seen.z);
      }
  }
};

/// Appends the pairs of i with begin ... end-1 that are nearer than the reach.
void append_near(LocalPositions const& at, std::size_t i, std::size_t begin, std::size_t end, float reach2,
                 std::vector<LocalPair>& found, std::size_t& count) {
  static_assert(sizeof(WideBits) == wide_count * sizeof(LocalPair) &&
                std::endian::native == std::endian::little);
  if (found.size() < count + (end - begin) + wide_count)
    found.resize(2 * (count + (end - begin) + wide_count));
  WideFloats const none{}, x = at.x[i] - none, y = at.y[i] - none, z = at.z[i] - none, reach = reach2 - none;
  constexpr WideBits lanes{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  for (std::size_t j = begin; j < end; j += wide_count) {
    WideFloats const dx = load<WideFloats>(&at.x[j]) - x, dy = load<WideFloats>(&at.y[j]) - y,
                     dz = load<WideFloats>(&at.z[j]) - z;
    unsigned const present = end - j < wide_count ? (1u << (end - j)) - 1 : 0xffffu;
    unsigned const bits = less(dx * dx + dy * dy + dz * dz, reach) & present;
    WideBits const pairs = ((lanes + static_cast<std::uint32_t>(j)) << 16) + static_cast<std::uint32_t>(i);
    compress(bits, pairs, &found[count]);
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

Neighbours::Neighbours(Box box, double range, double skin, int threads, std::array<bool, 3> open)
    : box_(box), range_(range), skin_(skin), threads_(threads), grid_(box, range + skin, open),
      lists_(grid_.blocks().size()) {}

bool Neighbours::outdated(std::span<Vec3 const> q) const {
  if (q_renewed_.empty())
    return true;
  double const allowed = skin_ * skin_ / 4;
  std::atomic<bool> far = false;
  for_each_part(q.size(), threads_, [&](std::size_t begin, std::size_t end) {
    bool some = false;
    for (std::size_t i = begin; i < end; ++i)
      some = some || !(norm2(q[i] - q_renewed_[i]) <= allowed);
    if (some)
      far.store(true, std::memory_order_relaxed);
  });
  return far;
}

void Neighbours::find_members(std::size_t block) {
  auto const& [cell, shift, pairs] = grid_.blocks()[block];
  auto& members = lists_[block].members;
  members.clear();
  for (std::size_t c = 0; c < cell.size(); ++c)
    members.push_back({cell_begin_[cell[c]], cell_begin_[cell[c] + 1], shift[c]});
}

void Neighbours::renew(Particles& particles) {
  for_each_index(particles.size(), threads_,
                 [&](std::size_t i) { particles.q[i] = box_.wrap(particles.q[i]); });
  sort(particles);
  lists_.resize(grid_.blocks().size());
  q_renewed_ = particles.q;
  ++renewals_;
  largest_block_ = 0;
  for (std::size_t block = 0; block < lists_.size(); ++block) {
    find_members(block);
    largest_block_ = std::max(largest_block_, size(members(block)));
  }
  std::size_t const most = std::numeric_limits<std::uint16_t>::max() - 1;
  if (largest_block_ > most)
    throw PhysicsError(
        fmt::format("{} of {} particles crowd into a few neighbouring cells (at most {} can be "
                    "handled): the system has collapsed",
                    largest_block_, particles.size(), most));
  for_each_block<Phases::at_once>(grid_, threads_,
                                  [&](std::size_t block) { find_candidates(block, particles.q); });
}

void Neighbours::sort(Particles& particles) {
  auto& [cell, next, order] = sorting_;
  order.resize(particles.size());
  grid_.place(particles.q, threads_, cell);
  cell_begin_.assign(grid_.cell_count() + 1, 0);
  for (Index const c : cell)
    ++cell_begin_[c + 1];
  std::partial_sum(cell_begin_.begin(), cell_begin_.end(), cell_begin_.begin());
  next.assign(cell_begin_.begin(), cell_begin_.end() - 1);
  for (std::size_t i = 0; i < particles.size(); ++i)
    order[next[cell[i]]++] = static_cast<Index>(i);
  for_each_index(grid_.cell_count(), threads_, [&](std::size_t c) {
    std::sort(order.begin() + cell_begin_[c], order.begin() + cell_begin_[c + 1],
              [&](Index a, Index b) { return particles.id[a] < particles.id[b]; });
  });
  auto each = [&]<class... T>(std::vector<T>&... values) {
    (reorder(values, std::get<std::vector<T>>(room_), order, threads_), ...);
  };
  each(particles.id, particles.species, particles.q, particles.p, particles.f, particles.caloric);
  for (auto const& field : fields)
    each(particles.*field.values);
}

void Neighbours::find_candidates(std::size_t block, std::span<Vec3 const> q) {
  thread_local LocalPositions at;
  thread_local std::vector<LocalPair> found;
  auto const all = members(block);
  at.copy(all, q);
  thread_local std::vector<std::size_t> begin;
  begin.assign(1, 0);
  for (auto const& cell : all)
    begin.push_back(begin.back() + (cell.end - cell.begin));
  // Wider by more than single precision errs within a block, which is a few reaches wide.
  double const wider = (1 + 1e-5) * reach();
  auto const reach2 = static_cast<float>(wider * wider);
  std::size_t count = 0;
  for (auto const& [a, b] : grid_.blocks()[block].pairs)
    for (std::size_t i = begin[a]; i < begin[a + 1]; ++i)
      append_near(at, i, a == b ? i + 1 : begin[b], begin[b + 1], reach2, found, count);
  auto& lists = lists_[block];
  order_in_matchings(std::span(found).first(count), begin.back(), lists.candidates, lists.candidate_ends);
  lists.pairs.reserve(count + wide_count); // no more than that: vectors that grow take up to twice as much
  lists.pairs.resize(count + wide_count);
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
