#include "sdpd/neighbours/matchings.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace mesobridge::sdpd {
namespace {

using Pairs = std::vector<LocalPair>;

std::vector<std::pair<int, int>> sorted(Pairs const& pairs) {
  std::vector<std::pair<int, int>> list;
  for (auto const [i, j] : pairs)
    list.emplace_back(i, j);
  std::sort(list.begin(), list.end());
  return list;
}

void expect_matchings(Pairs const& pairs, std::size_t particles) {
  Pairs ordered;
  std::vector<std::uint32_t> ends;
  order_in_matchings(pairs, particles, ordered, ends);
  EXPECT_EQ(sorted(ordered), sorted(pairs));
  std::vector<std::size_t> degree(particles, 0);
  for (auto const [i, j] : pairs)
    ++degree[i], ++degree[j];
  std::size_t const most = *std::max_element(degree.begin(), degree.end());
  EXPECT_GE(ends.size(), most); // no colouring can do with fewer
  EXPECT_LE(ends.size(), 2 * most - 1);
  std::size_t begin = 0;
  for (auto const end : ends) {
    ASSERT_GT(end, begin);
    std::set<int> seen;
    for (; begin < end; ++begin)
      ASSERT_TRUE(seen.insert(ordered[begin].i).second && seen.insert(ordered[begin].j).second);
  }
  EXPECT_EQ(begin, pairs.size());
}

TEST(Matchings, HoldEveryPairOnceAndNoParticleTwice) {
  std::mt19937 random(5);
  Pairs pairs;
  std::set<std::pair<int, int>> known;
  while (pairs.size() < 5000) {
    auto const [i, j] =
        std::minmax<int>({static_cast<int>(random() % 200), static_cast<int>(random() % 200)});
    if (i != j && known.insert({i, j}).second)
      pairs.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)});
  }
  expect_matchings(pairs, 200);
}

TEST(Matchings, ServeAParticleWithMorePairsThanTheFirstWordsHave) {
  Pairs star;
  for (std::uint16_t j = 1; j < 500; ++j)
    star.push_back({0, j});
  expect_matchings(star, 500);
}

TEST(Matchings, OfNothingAreNone) {
  Pairs ordered(3);
  std::vector<std::uint32_t> ends(2);
  order_in_matchings({}, 10, ordered, ends);
  EXPECT_TRUE(ordered.empty() && ends.empty());
}

} // namespace
} // namespace mesobridge::sdpd
