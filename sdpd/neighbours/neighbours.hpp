#pragma once
#include "sdpd/neighbours/cells.hpp"
#include <span>
#include <tuple>

namespace mesobridge::sdpd {

/// Two particles of a block by their places in it. The block's cells follow each other, and its pairs are
/// worked on in a copy of its particles: small, close together, in one periodic image.
struct LocalPair {
  std::uint16_t i, j;
};
static_assert(sizeof(LocalPair) == 4);

/// One cell's particles as members of a block: they are begin ... end-1 in memory, moved by `shift`.
struct Members {
  Index begin, end;
  Vec3 shift;
};
using BlockMembers = std::span<Members const>; ///< valid until the lists are renewed

inline std::size_t size(BlockMembers const& members) {
  std::size_t n = 0;
  for (auto const& cell : members)
    n += cell.end - cell.begin;
  return n;
}

/// Where the particle at place `local` of a block is in memory.
Index global_index(BlockMembers const& members, std::size_t local);

/// Lists of pairs by block. Candidates, which may come within the interaction's range before the lists are
/// renewed, are found when they are; the pairs in range are picked from them each time that the particles
/// have moved. A block's pairs are ordered in matchings: within a matching no particle occurs twice, so that
/// several of its pairs can be worked on at once, and the result is that of one after the other. Which pairs
/// there are, and their order, depends on the positions at the last renewal and now, on nothing else.
class Neighbours {
 public:
  /// Along edges of the box that are `open` particles may go as far as they like.
  Neighbours(Box box, double range, double skin, int threads, std::array<bool, 3> open = {});

  double range() const { return range_; }
  double reach() const { return range_ + skin_; } ///< of the candidates at a renewal
  double skin() const { return skin_; }
  CellGrid const& grid() const { return grid_; }
  std::uint64_t renewals() const { return renewals_; } ///< tells whether lists are those of an earlier look

  /// True when some particle has moved by more than half the skin since the last renewal (or there was none).
  bool outdated(std::span<Vec3 const> q) const;

  /// Wraps the particles into the box, sorts them by (cell, id) and finds the candidates. Throws PhysicsError
  /// when more than 65534 particles crowd into one block.
  void renew(Particles& particles);

  /// Positions at the last renewal, in today's order: with them a restart renews the same lists.
  std::span<Vec3 const> positions_at_renewal() const { return q_renewed_; }

  BlockMembers members(std::size_t block) const { return lists_[block].members; }
  std::size_t largest_block() const { return largest_block_; }

  std::span<LocalPair const> candidates(std::size_t block) const { return lists_[block].candidates; }
  /// Where each matching of the candidates ends.
  std::span<std::uint32_t const> candidate_ends(std::size_t block) const {
    return lists_[block].candidate_ends;
  }

  /// The pairs in range (see select_pairs), and where each of their matchings ends. The first has room for
  /// all candidates and wide_count more; set_pair_count says how much of it is in use.
  std::span<LocalPair> pair_room(std::size_t block) { return lists_[block].pairs; }
  std::span<std::uint32_t> pair_ends(std::size_t block) { return lists_[block].pair_ends; }
  void set_pair_count(std::size_t block, std::size_t count) { lists_[block].pair_count = count; }
  std::span<LocalPair const> pairs(std::size_t block) const {
    return std::span(lists_[block].pairs).first(lists_[block].pair_count);
  }
  std::span<std::uint32_t const> pair_ends(std::size_t block) const { return lists_[block].pair_ends; }
  std::size_t pair_count() const;

 private:
  struct BlockLists {
    std::vector<Members> members;
    std::vector<LocalPair> candidates, pairs;
    std::vector<std::uint32_t> candidate_ends, pair_ends;
    std::size_t pair_count = 0;
  };
  /// What a sort works with, kept so that no renewal allocates.
  struct Sorting {
    std::vector<Index> cell, next, order;
  };
  void sort(Particles& particles);
  void find_members(std::size_t block);
  void find_candidates(std::size_t block, std::span<Vec3 const> q);

  Box box_;
  double range_, skin_;
  int threads_;
  CellGrid grid_;
  std::size_t largest_block_ = 0;
  std::uint64_t renewals_ = 0;
  std::vector<Index> cell_begin_;
  Sorting sorting_;
  std::tuple<std::vector<std::uint32_t>, std::vector<double>, std::vector<Vec3>, std::vector<Caloric>> room_;
  std::vector<Vec3> q_renewed_;
  std::vector<BlockLists> lists_;
};

} // namespace mesobridge::sdpd
