#include "cg/force_matching.hpp"
#include "cg/pair_force_basis.hpp"
#include "error_text.hpp"
#include "pair_monte_carlo.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <random>

namespace mesobridge::cg {
namespace {

using tests::lennard_jones;
using tests::PairLaw;
using tests::PairMonteCarlo;
using tests::soft;

/// Adds the forces that the law gives all particles, and noise of that standard deviation.
void add_forces(MoleculeForces& all, PairLaw const& law, double noise, std::mt19937_64& bits) {
  std::normal_distribution<double> normal(0, 1);
  for (std::size_t k = 0; k < all.instants(); ++k)
    for (auto const& F :
         tests::forces_of(law, std::span(all.R).subspan(k * all.molecules, all.molecules), all.boxes[k]))
      all.F.push_back(F + noise * Vec3{normal(bits), normal(bits), normal(bits)});
}

MoleculeForces sampled(PairMonteCarlo& fluid, int settle, int instants, int sweeps) {
  MoleculeForces all{.molecules = fluid.positions().size(), .boxes = {}, .R = {}, .F = {}};
  for (int k = 0; k < settle; ++k)
    fluid.sweep();
  for (int k = 0; k < instants; ++k) {
    for (int n = 0; n < sweeps; ++n)
      fluid.sweep();
    all.boxes.push_back(fluid.box());
    all.R.insert(all.R.end(), fluid.positions().begin(), fluid.positions().end());
  }
  return all;
}

MoleculeForces at_random(double edge, std::size_t molecules, int instants, std::mt19937_64& bits) {
  std::uniform_real_distribution<double> place(0, edge);
  MoleculeForces all{.molecules = molecules, .boxes = {}, .R = {}, .F = {}};
  for (int k = 0; k < instants; ++k) {
    all.boxes.push_back({{edge, edge, edge}});
    for (std::size_t m = 0; m < molecules; ++m)
      all.R.push_back({place(bits), place(bits), place(bits)});
  }
  return all;
}

// Whatever force the splines can be comes out again, without an error.
TEST(ForceMatching, FindsAForceOfItsOwnSplines) {
  std::mt19937_64 bits(4);
  PairForceBasis const basis(0, 3, 0.5);
  std::vector<double> a;
  for (std::size_t j = 0; j < basis.size(); ++j)
    a.push_back(3 + std::sin(1.0 + double(j) * double(j)));
  auto const combined = [&](std::vector<double> const& values) {
    return std::inner_product(a.begin(), a.end(), values.begin(), 0.0);
  };
  PairLaw const law{3, {}, [&](double r) { return combined(basis.forces(r)); }};
  auto forces = at_random(8, 100, 64, bits);
  add_forces(forces, law, 0, bits);
  auto const found = match_forces(forces, {.cutoff = 3, .width = 0.25, .knots = 0.5});
  ASSERT_EQ(found.first, 0);
  ASSERT_EQ(found.f.size(), 12u);
  EXPECT_NEAR(found.explained.mean, 1, 1e-12);
  double squares = 0;
  for (auto const& F : forces.F)
    squares += norm2(F) / double(3 * forces.F.size());
  EXPECT_NEAR(found.mean_square.mean, squares, 1e-9 * squares);
  double below = 0; // the potential by steps of its own
  constexpr int steps = 2000;
  for (std::size_t k = 12; k-- > 0;) {
    double const r = found.r(k);
    EXPECT_NEAR(found.f[k].mean, law.f(r), 1e-9) << r;
    EXPECT_LT(found.f[k].se, 1e-9) << r;
    double const from = k == 11 ? 3 : found.r(k + 1);
    for (int n = 0; n < steps; ++n)
      below += law.f(r + (n + 0.5) * (from - r) / steps) * (from - r) / steps;
    EXPECT_NEAR(found.u[k].mean, below, 1e-5) << r;
  }
}

// Where no pairs are, the force goes to zero in proportion to the distance, and the potential as a + b r^2.
TEST(ForceMatching, GoesOnIntoTheCore) {
  PairForceBasis const basis(1, 3, 0.5);
  auto const at = basis.forces(1), inside = basis.forces(0.4), u_1 = basis.potentials(1),
             u_0 = basis.potentials(0);
  for (std::size_t j = 0; j < basis.size(); ++j) {
    EXPECT_NEAR(inside[j], 0.4 * at[j], 1e-12);
    EXPECT_NEAR(u_0[j] - u_1[j], 0.5 * at[j], 1e-12);
  }
}

/// What is found of a soft fluid whose forces have noise.
auto soft_fluid_matched(PairLaw const& law, double noise, std::uint64_t seed) {
  std::mt19937_64 bits(5);
  PairMonteCarlo fluid(law, 5, 3, 0.3, seed);
  auto forces = sampled(fluid, 200, 320, 3);
  add_forces(forces, law, noise, bits);
  return match_forces(forces, {.cutoff = 1, .width = 0.05, .knots = 0.1});
}

TEST(ForceMatching, FindsTheSoftForceThatWasPutIn) {
  auto const law = soft(25);
  auto const found = soft_fluid_matched(law, 5, 6);
  EXPECT_LT(found.first, 0.3);
  for (std::size_t k = 0; k < found.f.size(); ++k)
    if (double const r = found.r(k); r > found.first) {
      EXPECT_NEAR(found.f[k].mean, law.f(r), 4 * found.f[k].se + 0.01) << r;
      EXPECT_NEAR(found.u[k].mean, law.u(r), 0.01 * law.u(0)) << r;
      EXPECT_LT(found.u[k].se, 0.005 * law.u(0)) << r;
    }
  EXPECT_LT(found.longer_blocks, 1.5);
}

// The force on a particle along the line to another, with that of all others, is the slope of k_BT ln g
// (Yvon).
TEST(ForceMatching, MeanForcesAreTheSlopeOfTheStructure) {
  auto const found = soft_fluid_matched(soft(25), 0, 7);
  auto const ln_g = [&](std::size_t k) { return std::log(found.pairs[k] / std::pow(found.r(k), 2)); };
  auto const relative = [&](std::size_t k) { return 1 / found.pairs[k]; };
  for (std::size_t from : {8u, 10u, 12u, 14u}) {
    std::size_t const to = from + 4;
    double work = 0.5 * found.width * (found.mean_force[from].mean + found.mean_force[to].mean);
    for (std::size_t k = from + 1; k < to; ++k)
      work += found.width * found.mean_force[k].mean;
    double const se = std::sqrt(relative(from) + relative(to)); // of ln g; the work's is smaller
    EXPECT_NEAR(ln_g(to) - ln_g(from), work, 4 * se + 0.02) << found.r(from);
  }
  EXPECT_GT(found.f[16].mean - found.mean_force[16].mean, 20 * found.f[16].se); // no pair force
}

TEST(ForceMatching, FindsTheLennardJonesForceThatWasPutIn) {
  std::mt19937_64 bits(8);
  auto const law = lennard_jones();
  PairMonteCarlo fluid(law, 6, 0.6, 0.15, 9);
  auto forces = sampled(fluid, 300, 160, 4);
  add_forces(forces, law, 1, bits);
  auto const found = match_forces(forces, {.cutoff = 2.5, .width = 0.05, .knots = 0.05});
  double depth = 0, compared = 0;
  for (double r = 1; r < 2.5; r += 0.01)
    depth = std::max(depth, -law.u(r));
  for (std::size_t k = 0; k < found.f.size(); ++k)
    if (double const r = found.r(k); r > 1) {
      EXPECT_NEAR(found.f[k].mean, law.f(r), 4 * found.f[k].se + 0.01) << r;
      EXPECT_NEAR(found.u[k].mean, law.u(r), 0.01 * depth) << r;
      ++compared;
    }
  EXPECT_EQ(compared, 30);
  EXPECT_GT(found.first, 0.8);
  EXPECT_LT(found.first, 1);
}

// Many series of the same fluid: each error must be the spread of its value.
TEST(ForceMatching, ErrorsAreTheSpread) {
  std::mt19937_64 bits(10);
  PairForceBasis const basis(0, 3, 1);
  PairLaw const law{3, {}, [](double r) { return std::pow(1 - r / 3, 3); }}; // one of the splines
  double squares = 0, count = 0;
  for (int series = 0; series < 60; ++series) {
    auto forces = at_random(7, 40, 32, bits);
    add_forces(forces, law, 2, bits);
    auto const found = match_forces(forces, {.cutoff = 3, .width = 0.3, .knots = 1});
    for (std::size_t k = 1; k < found.f.size(); ++k) {
      squares += std::pow((found.f[k].mean - law.f(found.r(k))) / found.f[k].se, 2);
      squares += std::pow((found.u[k].mean - std::pow(1 - found.r(k) / 3, 4) * 0.75) / found.u[k].se, 2);
      count += 2;
    }
  }
  double const freedom = 15; // of the error: t-distributed
  EXPECT_NEAR(std::sqrt(squares / count / (freedom / (freedom - 2))), 1, 0.12);
}

// Forces that last longer than a block: the errors grow with the blocks, and that is said.
TEST(ForceMatching, TellsThatBlocksAreTooShort) {
  std::mt19937_64 bits(11);
  std::normal_distribution<double> normal;
  auto forces = at_random(7, 40, 32, bits);
  for (std::size_t k = 0; k < forces.instants(); ++k) // nothing moves for 16 instants
    for (std::size_t m = 0; m < 40; ++m) {
      bool const same = k % 16 != 0;
      if (same)
        forces.R[k * 40 + m] = forces.R[(k - 1) * 40 + m];
      Vec3 const last = same ? forces.F[(k - 1) * 40 + m] : Vec3{};
      forces.F.push_back(same ? last : Vec3{normal(bits), normal(bits), normal(bits)});
    }
  EXPECT_GT(match_forces(forces, {.cutoff = 3, .width = 0.3, .knots = 1}).longer_blocks, 1.3);
  forces.independent = true;
  EXPECT_EQ(match_forces(forces, {.cutoff = 3, .width = 0.3, .knots = 1}).longer_blocks, 1);
}

TEST(ForceMatching, RefusesByName) {
  std::mt19937_64 bits(12);
  auto forces = at_random(7, 40, 8, bits);
  add_forces(forces, soft(25), 1, bits);
  auto const refused = [](MoleculeForces const& of, ForceMatchingSettings const& s, std::string const& word) {
    auto const text = tests::error_text([&] { match_forces(of, s); });
    EXPECT_NE(text.find(word), std::string::npos) << text;
  };
  refused(forces, {.cutoff = 3.6}, "half of the box");
  refused(forces, {.cutoff = 0}, "cutoff");
  refused(forces, {.cutoff = 3, .width = 0}, "bin width");
  refused(forces, {.cutoff = 3, .width = 1}, "bins within");
  refused(forces, {.cutoff = 3, .knots = 0}, "knots");
  refused(forces, {.cutoff = 3, .knots = 0.001}, "too close"); // fewer pairs than coefficients
  auto few = at_random(7, 25, 4, bits);
  add_forces(few, soft(25), 1, bits);
  refused(few, {.cutoff = 3, .width = 0.25, .knots = 0.02}, "too close");
  auto one = forces;
  one.boxes.resize(1), one.R.resize(40), one.F.resize(40);
  refused(one, {.cutoff = 3}, "frames");
  auto none = forces;
  std::fill(none.F.begin(), none.F.end(), Vec3{});
  refused(none, {.cutoff = 3}, "all in the file are zero");
}

} // namespace
} // namespace mesobridge::cg
