#pragma once
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Narrows the lists of pairs in range to those for which keep(i, j) holds (places in memory), matchings and
/// order as they were, until the end of its life. The order in memory must not change meanwhile.
class SelectedPairs {
 public:
  template <class Keep>
  SelectedPairs(System& system, Keep const& keep)
      : neighbours_(system.neighbours), all_(neighbours_.grid().blocks().size()) {
    for_each_index(all_.size(), system.threads, [&](std::size_t block) { select(block, keep); });
  }
  ~SelectedPairs() {
    for (std::size_t block = 0; block < all_.size(); ++block) {
      auto const& [pairs, ends] = all_[block];
      std::copy(pairs.begin(), pairs.end(), neighbours_.pair_room(block).begin());
      std::copy(ends.begin(), ends.end(), neighbours_.pair_ends(block).begin());
      neighbours_.set_pair_count(block, pairs.size());
    }
  }
  SelectedPairs(SelectedPairs const&) = delete;
  SelectedPairs& operator=(SelectedPairs const&) = delete;

 private:
  struct Lists {
    std::vector<LocalPair> pairs;
    std::vector<std::uint32_t> ends;
  };

  template <class Keep>
  void select(std::size_t block, Keep const& keep) {
    auto const pairs = std::as_const(neighbours_).pairs(block);
    auto const ends = neighbours_.pair_ends(block);
    all_[block] = {{pairs.begin(), pairs.end()}, {ends.begin(), ends.end()}};
    std::vector<Index> index(size(neighbours_.members(block)));
    for_each_member(neighbours_.members(block),
                    [&](std::size_t local, Index i, Vec3 const&) { index[local] = i; });
    auto const room = neighbours_.pair_room(block);
    std::uint32_t count = 0, k = 0;
    for (auto& end : ends) {
      for (; k < end; ++k) {
        LocalPair const pair = room[k];
        if (keep(index[pair.i], index[pair.j]))
          room[count++] = pair;
      }
      end = count;
    }
    neighbours_.set_pair_count(block, count);
  }

  Neighbours& neighbours_;
  std::vector<Lists> all_;
};

} // namespace mesobridge::sdpd
