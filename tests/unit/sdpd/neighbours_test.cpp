#include "md/error.hpp"
#include "sdpd/neighbours/neighbours.hpp"
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace mesobridge::sdpd {
namespace {

using IdPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Particles random_particles(Box const& box, std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-0.5, 1.5); // some outside the box: renewal wraps them
  Particles particles;
  particles.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    particles.id[i] = static_cast<std::uint32_t>(n - 1 - i);
    particles.q[i] = {u(random) * box.edge.x, u(random) * box.edge.y, u(random) * box.edge.z};
  }
  return particles;
}

IdPairs brute_force(Particles const& particles, Box const& box, double range) {
  IdPairs pairs;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (norm(box.minimum_image(particles.q[i] - particles.q[j])) < range)
        pairs.insert(std::minmax(particles.id[i], particles.id[j]));
  return pairs;
}

/// Calls f(global i, global j, separation) for all candidates.
template <class F>
void for_each_candidate(Particles const& particles, Neighbours const& neighbours, F&& f) {
  for (std::size_t block = 0; block < neighbours.grid().blocks().size(); ++block) {
    auto const members = neighbours.members(block);
    std::vector<Index> index;
    std::vector<Vec3> q;
    for (auto const& cell : members)
      for (Index i = cell.begin; i < cell.end; ++i) {
        index.push_back(i);
        q.push_back(particles.q[i] + cell.shift);
        ASSERT_EQ(global_index(members, index.size() - 1), i);
      }
    for (auto const [i, j] : neighbours.candidates(block))
      f(index[i], index[j], q[i] - q[j]);
  }
}

IdPairs from_lists(Particles const& particles, Neighbours const& neighbours) {
  IdPairs pairs;
  std::size_t listed = 0;
  for_each_candidate(particles, neighbours, [&](Index i, Index j, Vec3 const& r) {
    if (norm(r) < neighbours.range()) {
      pairs.insert(std::minmax(particles.id[i], particles.id[j]));
      ++listed;
    }
  });
  EXPECT_EQ(listed, pairs.size()); // none twice
  return pairs;
}

TEST(Neighbours, AreThoseOfABruteForceSearchUntilTheListsAreOutdated) {
  std::size_t boxes = 0;
  for (Vec3 const edge : {Vec3{2.5, 2.5, 2.5}, Vec3{3.7, 4.2, 2.9}, Vec3{6, 5, 7}}) {
    Box const box{edge};
    auto particles = random_particles(box, 400, 11);
    Neighbours neighbours(box, 1.0, 0.2, 1);
    EXPECT_TRUE(neighbours.outdated(particles.q));
    neighbours.renew(particles);
    EXPECT_EQ(from_lists(particles, neighbours), brute_force(particles, box, 1.0));
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> step(-0.057,
                                                0.057); // at most 0.0988 in length, less than half the skin
    for (auto& q : particles.q)
      q += {step(random), step(random), step(random)};
    EXPECT_FALSE(neighbours.outdated(particles.q));
    EXPECT_EQ(from_lists(particles, neighbours), brute_force(particles, box, 1.0));
    particles.q[7].x += 0.2;
    EXPECT_TRUE(neighbours.outdated(particles.q));
    ++boxes;
  }
  EXPECT_EQ(boxes, 3u);
}

TEST(Neighbours, ListTheSamePairsInTheSameOrderForAnyOrderInMemory) {
  Box const box{{4, 4, 4}};
  auto a = random_particles(box, 300, 2);
  auto b = a;
  std::reverse(b.id.begin(), b.id.end());
  std::reverse(b.q.begin(), b.q.end());
  Neighbours of_a(box, 1.0, 0.1, 1), of_b(box, 1.0, 0.1, 2);
  of_a.renew(a), of_b.renew(b);
  auto listed = [](Particles const& particles, Neighbours const& neighbours) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ids;
    for_each_candidate(particles, neighbours, [&](Index i, Index j, Vec3 const&) {
      ids.emplace_back(particles.id[i], particles.id[j]);
    });
    return ids;
  };
  auto const in_a = listed(a, of_a);
  EXPECT_GT(in_a.size(), 1000u);
  EXPECT_EQ(in_a, listed(b, of_b));
}

TEST(Neighbours, RefuseToHandleASystemThatHasCollapsed) {
  Box const box{{40, 40, 40}};
  Particles particles;
  particles.resize(66000);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.id[i] = static_cast<std::uint32_t>(i);
    particles.q[i] = {1, 1, 1};
  }
  Neighbours neighbours(box, 1.0, 0.2, 1);
  EXPECT_THROW(neighbours.renew(particles), PhysicsError);
}

} // namespace
} // namespace mesobridge::sdpd
