#include "cg/nonnegative_squares.hpp"
#include "cg/pair_friction.hpp"
#include "error_text.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace mesobridge::cg {
namespace {

/// Particles at random places, whose pairs push and pull each other by noise of a known memory:
/// gamma_theta = a_theta (1 - r/cutoff)^2 by the trapezoidal rule.
struct NoisyPairs {
  double par = 5, perp = 2, cutoff = 3, kT = 1.5, interval = 0.1, memory = 0.6, edge = 7;
  std::size_t molecules = 60, frames = 400;

  double weight(double r) const { return r < cutoff ? (1 - r / cutoff) * (1 - r / cutoff) : 0; }
  /// The integral of a noise of variance one.
  double integral() const { return interval * (0.5 + memory / (1 - memory)); }

  HeldConfiguration configuration(std::mt19937_64& bits) const {
    std::uniform_real_distribution<double> place(0, edge);
    std::normal_distribution<double> normal;
    HeldConfiguration one{
        .box = {{edge, edge, edge}}, .R = {}, .F = std::vector<Vec3>(molecules * frames), .kT = kT};
    for (std::size_t m = 0; m < molecules; ++m)
      one.R.push_back({place(bits), place(bits), place(bits)});
    for (std::size_t a = 0; a < molecules; ++a)
      for (std::size_t b = a + 1; b < molecules; ++b) {
        Vec3 const apart = one.box.minimum_image(one.R[a] - one.R[b]);
        double const w = weight(norm(apart)), along = std::sqrt(par * kT * w / integral()),
                     across = std::sqrt(perp * kT * w / integral());
        if (w == 0)
          continue;
        Vec3 const e = apart / norm(apart);
        Vec3 noise{normal(bits), normal(bits), normal(bits)};
        for (std::size_t k = 0; k < frames; ++k) {
          Vec3 const fresh{normal(bits), normal(bits), normal(bits)};
          noise = memory * noise + std::sqrt(1 - memory * memory) * fresh;
          Vec3 const F = across * noise + (along - across) * dot(noise, e) * e;
          one.F[k * molecules + a] += F, one.F[k * molecules + b] -= F;
        }
      }
    return one;
  }
  std::vector<HeldConfiguration> configurations(std::size_t count, unsigned seed) const {
    std::mt19937_64 bits(seed);
    std::vector<HeldConfiguration> all;
    for (std::size_t k = 0; k < count; ++k)
      all.push_back(configuration(bits));
    return all;
  }
  /// What the particles' own friction is on average.
  double self(std::vector<HeldConfiguration> const& all) const {
    double sum = 0;
    for (auto const& one : all)
      for (std::size_t a = 0; a < molecules; ++a)
        for (std::size_t b = 0; b < molecules; ++b)
          if (a != b)
            sum += (par + 2 * perp) / 3 * weight(norm(one.box.minimum_image(one.R[a] - one.R[b])));
    return sum / double(all.size() * molecules);
  }
  /// The mean weight in a bin of uniform pairs.
  double mean_weight(double from, double to) const {
    double sum = 0, pairs = 0;
    for (int k = 0; k < 200; ++k) {
      double const r = from + (to - from) * (k + 0.5) / 200;
      sum += weight(r) * r * r, pairs += r * r;
    }
    return sum / pairs;
  }
};

void nothing(std::size_t) {}

TEST(PairFriction, ThatIsPutInComesOut) {
  NoisyPairs const fluid;
  auto const all = fluid.configurations(16, 3);
  auto const found = pair_friction(all, {.interval = fluid.interval, .cutoff = 3, .knots = 0.75}, nothing);
  // Without what the mean over the run takes off, 8 % would be missing.
  double const self = fluid.self(all);
  EXPECT_LT(std::abs(deviation(found.self, self)), 4) << found.self.mean << " " << self;
  EXPECT_GT(std::abs(deviation(found.self, 0.92 * self)), 4);
  EXPECT_LT(std::abs(deviation(found.self_integral.back(), self)), 4) << "a plateau";
  EXPECT_LT(std::abs(deviation(found.rise, 0)), 4);
  EXPECT_NEAR(found.memory, fluid.integral(), 0.15 * fluid.integral());
  int bins = 0, far = 0;
  for (auto const& bin : found.bins) {
    double const w = fluid.mean_weight(bin.r - 0.25, bin.r + 0.25);
    EXPECT_LT(std::abs(deviation(bin.par, fluid.par * w)), 4) << bin.r;
    EXPECT_LT(std::abs(deviation(bin.perp, fluid.perp * w)), 4) << bin.r;
    if (bin.r > 0.5 && bin.r < 2) {
      EXPECT_GT(std::abs(deviation(bin.par, fluid.perp * w)), 4) << "along is not across";
      ++far;
    }
    ++bins;
  }
  EXPECT_EQ(bins, 7);
  EXPECT_EQ(far, 3);
  EXPECT_LT(std::abs(deviation(found.near, self)), 4) << "no friction beyond the cut-off";
}

TEST(PairFriction, OfTheTableObeysTheSumRuleAndIsWhatWasPutIn) {
  NoisyPairs const fluid;
  auto const all = fluid.configurations(16, 4);
  auto const found = pair_friction(all, {.interval = fluid.interval, .cutoff = 3, .knots = 0.75}, nothing);
  auto const& table = found.table;
  EXPECT_EQ(table.par.back(), 0);
  EXPECT_EQ(table.perp.back(), 0);
  EXPECT_NEAR(found.table_sum / found.self.mean, 1, 1e-9);
  int seen = 0;
  for (std::size_t k = 0; k < table.r.size(); ++k) {
    EXPECT_GE(table.par[k], 0);
    EXPECT_GE(table.perp[k], 0);
    double const w = fluid.weight(table.r[k]);
    if (table.r[k] < 0.6 || table.r[k] > 2.4)
      continue;
    EXPECT_NEAR(table.par[k], fluid.par * w, 5 * found.par_se[k] + 0.02 * fluid.par) << table.r[k];
    EXPECT_NEAR(table.perp[k], fluid.perp * w, 5 * found.perp_se[k] + 0.02 * fluid.perp) << table.r[k];
    EXPECT_LT(found.par_se[k], 0.1 * fluid.par);
    ++seen;
  }
  EXPECT_GT(seen, 10);
}

TEST(PairFriction, FindsWhereFrictionEnds) {
  NoisyPairs const fluid{.frames = 800};
  auto const found = pair_friction(fluid.configurations(8, 5), {.interval = 0.1}, nothing);
  EXPECT_GE(found.table.cutoff(), 2.5);
  EXPECT_LE(found.table.cutoff(), 3.5);
}

TEST(PairFriction, OfForcesThatSayNoneIsRefused) {
  NoisyPairs const fluid{.molecules = 20, .frames = 400};
  auto const good = fluid.configurations(4, 6);
  auto const refusal = [](std::vector<HeldConfiguration> const& all, FrictionSettings const& settings) {
    return tests::error_text([&] { pair_friction(all, settings, nothing); });
  };
  FrictionSettings const usual{.interval = 0.1, .cutoff = 3};
  EXPECT_EQ(refusal(good, usual), "no error");
  auto changed = [&](auto const& change) {
    auto all = good;
    change(all);
    return refusal(all, usual);
  };
  EXPECT_NE(changed([](auto& all) { all.resize(3); }).find("configurations"), std::string::npos);
  EXPECT_NE(changed([](auto& all) { all[1].F.resize(20 * 200); }).find("frames"), std::string::npos);
  EXPECT_NE(changed([](auto& all) { all[2].R.pop_back(); }).find("molecules"), std::string::npos);
  EXPECT_NE(changed([](auto& all) { all[3].kT = 0; }).find("temperature"), std::string::npos);
  EXPECT_NE(changed([](auto& all) {
              for (auto& one : all)
                one.F.resize(20 * 30);
            }).find("at least 64"),
            std::string::npos);
  EXPECT_NE(changed([](auto& all) {
              for (auto& one : all)
                for (std::size_t k = 0; k < one.F.size(); ++k)
                  one.F[k] = one.F[k] * (k / 20 % 2 == 0 ? 1 : -1);
            }).find("more often"),
            std::string::npos);
  struct Case {
    FrictionSettings settings;
    char const* says;
  };
  int cases = 0;
  for (auto const& [settings, says] : {Case{{.interval = 0}, "interval"},
                                       {{.interval = 0.1, .bin_width = -1}, "width"},
                                       {{.interval = 0.1, .bin_width = 3}, "width"},
                                       {{.interval = 0.1, .bin_width = 1e-9}, "width"},
                                       {{.interval = 0.1, .plateau = 3}, "held"},
                                       {{.interval = 0.1, .plateau = NAN}, "plateau"},
                                       {{.interval = 0.1, .cutoff = 30}, "cut-off"},
                                       {{.interval = 0.1, .cutoff = NAN}, "cut-off"},
                                       {{.interval = 0.1, .cutoff = 3, .knots = 0}, "knots"}}) {
    EXPECT_NE(refusal(good, settings).find(says), std::string::npos)
        << says << ": " << refusal(good, settings);
    ++cases;
  }
  EXPECT_EQ(cases, 9);
}

TEST(PairFriction, ThatIsOnlyNoiseIsNone) {
  NoisyPairs const fluid{.molecules = 20, .frames = 400};
  auto all = fluid.configurations(4, 6);
  std::mt19937_64 bits(9);
  for (auto& one : all) // forces of a pair no longer belong together
    for (std::size_t m = 0; m < 20; ++m) {
      std::size_t const shift = bits() % 400;
      auto const before = one.F;
      for (std::size_t k = 0; k < 400; ++k)
        one.F[k * 20 + m] = before[(k + shift) % 400 * 20 + m];
    }
  EXPECT_THROW(pair_friction(all, {.interval = 0.1}, nothing), PhysicsError);
}

TEST(NonnegativeSquares, OfKnownSolutions) {
  std::vector<double> const identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
  auto const near = [](std::vector<double> const& x, std::vector<double> const& y) {
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t k = 0; k < x.size(); ++k)
      EXPECT_NEAR(x[k], y[k], 1e-5) << k;
  };
  near(nonnegative_squares(identity, {1, -2, 3}), {1, 0, 3});
  near(nonnegative_squares(identity, {1, -2, 3}, {1, 1, 1}, 6), {2, 0, 4});
  near(nonnegative_squares(identity, {1, -2, 3}, {1, 1, 1}, 1), {0, 0, 1});
  // The free minimum of these two is (-1, 3): the first may not be negative, the second follows.
  near(nonnegative_squares({2, 1, 1, 1}, {1, 2}), {0, 2});
  EXPECT_THROW(nonnegative_squares({-1}, {1}), PhysicsError) << "not positive definite";
}

} // namespace
} // namespace mesobridge::cg
