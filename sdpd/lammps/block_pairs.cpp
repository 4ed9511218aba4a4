#include "md/error.hpp"
#include "sdpd/lammps/block_sweep.hpp"
#include "sdpd/neighbours/matchings.hpp"
#include "sdpd/neighbours/unit_pairs.hpp"
#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

// The cells of a sweep, the blocks that they make and the pairs in these.

namespace mesobridge::sdpd {
namespace {

std::uint32_t cells_along(double edge, double range) {
  return static_cast<std::uint32_t>(edge / (2 * range)) * 2;
}

} // namespace

std::optional<PairScheme> scheme_in_turn(std::string_view integrator) {
  if (integrator == "ssa")
    return PairScheme::ssa;
  if (integrator == "ams")
    return PairScheme::ams;
  if (integrator == "ems")
    return PairScheme::ems;
  return std::nullopt;
}

bool BlockSweep::fits(Box const& box, double range) {
  constexpr std::uint32_t fewest = 4;
  return std::min({cells_along(box.edge.x, range), cells_along(box.edge.y, range),
                   cells_along(box.edge.z, range)}) >= fewest;
}

BlockSweep::BlockSweep(Box const& box, double range)
    : box_(box), range_(range), count_{cells_along(box.edge.x, range), cells_along(box.edge.y, range),
                                       cells_along(box.edge.z, range)},
      cell_{box.edge.x / count_[0], box.edge.y / count_[1], box.edge.z / count_[2]} {}

BlockSweep::Cell BlockSweep::cell_of(double const* q) const {
  Vec3 const at = box_.wrap({q[0], q[1], q[2]});
  auto along = [](double x, double edge, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>(x / edge), count - 1);
  };
  return {along(at.x, cell_.x, count_[0]), along(at.y, cell_.y, count_[1]), along(at.z, cell_.z, count_[2])};
}

void BlockSweep::sort_into_cells(RankParticles const& particles) {
  std::size_t const cells = std::size_t{count_[0]} * count_[1] * count_[2];
  auto const cell_of_particle = [&](std::size_t i) {
    return static_cast<std::size_t>(fixed_[fixed_stride * i + cell]);
  };
  begins_.assign(cells + 1, 0);
  for (std::size_t i = 0; i < particles.all; ++i)
    ++begins_[cell_of_particle(i) + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  counts_.assign(cells, 0);
  members_.resize(particles.all);
  for (std::size_t i = 0; i < particles.all; ++i) {
    auto const at = cell_of_particle(i);
    members_[begins_[at] + counts_[at]++] = {particles.id(i), static_cast<std::uint32_t>(i)};
  }
  for (std::size_t at = 0; at < cells; ++at) {
    auto const here = std::span(members_).subspan(begins_[at], counts_[at]);
    std::ranges::sort(here);
    counts_[at] =
        static_cast<std::uint32_t>(std::ranges::unique(here, {}, &Member::id).begin() - here.begin());
  }
}

std::span<BlockSweep::Member const> BlockSweep::members(Cell const& at) const {
  auto const of = number(at);
  return std::span(members_).subspan(begins_[of], counts_[of]);
}

/// Along each axis the cells that begin blocks whose middles lie in this rank's part of the box.
std::array<std::vector<std::uint32_t>, 3> BlockSweep::own_blocks(RankParticles const& particles) const {
  std::array<std::vector<std::uint32_t>, 3> blocks;
  for (unsigned axis = 0; axis < 3; ++axis)
    for (std::uint32_t k = 0; k < count_[axis]; ++k) {
      double const middle = (k + 1) % count_[axis] * component(cell_, static_cast<int>(axis));
      if (middle >= particles.low[axis] && middle < particles.high[axis])
        blocks[axis].push_back(k);
    }
  return blocks;
}

/// One more block's particles, with positions from its first one's, and their states; then its pairs.
void BlockSweep::add_block(RankParticles const& particles, Cell const& base) {
  std::size_t const begin = block_.size();
  for (unsigned k = 0; k < 8; ++k) {
    cells_[k] = block_.size();
    auto const here = members({(base[0] + (k & 1u)) % count_[0], (base[1] + (k >> 1u & 1u)) % count_[1],
                               (base[2] + (k >> 2u)) % count_[2]});
    block_.insert(block_.end(), here.begin(), here.end());
  }
  std::size_t const end = cells_[8] = block_.size();
  constexpr std::size_t most = std::numeric_limits<decltype(LocalPair::i)>::max() - 1; // with two phantoms
  if (end > most)
    throw PhysicsError(fmt::format("{} particles crowd into a few neighbouring cells (at most {} can be "
                                   "handled): the system has collapsed",
                                   end, most));
  auto const place = [&](Member const& of) {
    double const* const q = particles.q + 3 * std::size_t{of.place};
    return Vec3{q[0], q[1], q[2]};
  };
  rows_.resize(end), states_.resize(end);
  for (auto& along : places_)
    along.resize(end + lane_count);
  for (std::size_t k = begin; k < end; ++k) {
    Vec3 const at = box_.minimum_image(place(block_[k]) - place(block_[begin]));
    double const* const fixed = &fixed_[fixed_stride * block_[k].place];
    rows_[k] = Row{at.x, at.y, at.z, 1 / fixed[density]};
    places_[0][k] = at.x, places_[1][k] = at.y, places_[2][k] = at.z;
    Row const& state = state_[block_[k].place];
    states_[k] = {{state[0], state[1], state[2]},
                  state[3],
                  {fixed[T_0], fixed[inverse_C_0], fixed[curvature], fixed[limit]}};
  }
  for (auto const& [one, other] : unit_pairs)
    add_pairs(one, other);
}

/// Those of two cells' particles that are in range.
void BlockSweep::add_pairs(unsigned one, unsigned other) {
  Lanes const range2 = broadcast(range_ * range_);
  std::size_t const end = cells_[other + 1];
  for (std::size_t i = cells_[one]; i < cells_[one + 1]; ++i) {
    auto const pair_with = [i](std::size_t j) {
      return LocalPair{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)};
    };
    for (std::size_t first = one == other ? i + 1 : cells_[other]; first < end; first += lane_count) {
      auto const apart = [&](std::vector<double> const& q) { return q[i] - load<Lanes>(&q[first]); };
      Lanes const x = apart(places_[0]), y = apart(places_[1]), z = apart(places_[2]);
      unsigned near = less(x * x + y * y + z * z, range2);
      if (end - first < lane_count)
        near &= (1u << (end - first)) - 1;
      for (; near != 0; near &= near - 1)
        pairs_.push_back(pair_with(first + static_cast<std::size_t>(std::countr_zero(near))));
    }
  }
}

/// Phantoms for what pairs leave over, and the pairs of all blocks in matchings.
void BlockSweep::finish_blocks() {
  rows_.push_back(Row{}), rows_.push_back(Row{range_ / 2, 0, 0, 0});
  FluctuatingParticle const phantom{{}, 0, {.T_0 = 1, .inverse_C_0 = 1, .curvature = 0, .limit = 1}};
  states_.push_back(phantom), states_.push_back(phantom);
  order_in_matchings(pairs_, block_.size(), ordered_, ends_);
}

} // namespace mesobridge::sdpd
