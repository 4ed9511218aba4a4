#include "cg/kolmogorov_smirnov.hpp"
#include "sdpd/state/random_lanes.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace mesobridge::sdpd {
namespace {

// Known answers of the Random123 distribution (kat_vectors, philox4x32 with 7 and 10 rounds).
TEST(Philox, GivesThePublishedKnownAnswers) {
  using C = Philox4x32::Counter;
  using K = Philox4x32::Key;
  std::uint32_t const f = 0xffffffff;
  C const zeros{0, 0, 0, 0}, ones{f, f, f, f}, pi{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344};
  K const more_pi{0xa4093822, 0x299f31d0};
  EXPECT_EQ(Philox4x32::generate(zeros, {0, 0}), (C{0x5f6fb709, 0x0d893f64, 0x4f121f81, 0x4f730a48}));
  EXPECT_EQ(Philox4x32::generate(ones, {f, f}), (C{0x5207ddc2, 0x45165e59, 0x4d8ee751, 0x8c52f662}));
  EXPECT_EQ(Philox4x32::generate(pi, more_pi), (C{0x4dfccaba, 0x190a87f0, 0xc47362ba, 0xb6b5242a}));
  EXPECT_EQ(Philox4x32::generate<10>(zeros, {0, 0}), (C{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(Philox4x32::generate<10>(ones, {f, f}), (C{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(Philox4x32::generate<10>(pi, more_pi), (C{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

std::vector<double> many_gaussians(NoiseSource const& source, std::uint32_t pairs) {
  std::vector<double> values;
  NoiseLanes const lanes(source);
  WideBits a{}, b{};
  for (std::uint32_t first = 0; first < pairs; first += wide_count) {
    for (std::uint32_t lane = 0; lane < wide_count; ++lane)
      a[lane] = first + lane, b[lane] = 3 * (first + lane) + 1;
    GaussianLanes const G(lanes, a, b);
    for (std::size_t lane = 0; lane < wide_count; ++lane)
      values.insert(values.end(), {G.x[lane], G.y[lane], G.z[lane]});
  }
  return values;
}

TEST(Gaussians, HaveRadiiAndDirectionsToSinglePrecision) {
  int radii = 0, turns = 0;
  for (float x = 0.5f; x <= 0x1p31f; x *= 1.00017f, ++radii) {
    double const exact = -2 * std::log(double{x} / 0x1p31);
    EXPECT_NEAR(detail::minus_two_logarithm(x - WideFloats{})[3], exact, 2.5e-7 * std::max(exact, 1e-30))
        << x;
  }
  EXPECT_EQ(detail::minus_two_logarithm(0x1p31f - WideFloats{})[3], 0);
  for (float x = -0.5f; x <= 0.5f; x += 0.0007f, ++turns) {
    EXPECT_NEAR(cosine_of_half_turn(x - WideFloats{})[0], std::cos(std::numbers::pi * x), 2.5e-7);
    EXPECT_NEAR(sine_of_half_turn(x - WideFloats{})[0], std::sin(std::numbers::pi * x), 2.5e-7);
  }
  EXPECT_GT(radii, 100000);
  EXPECT_GT(turns, 1400);
}

// The angles of all 2^23 intervals: a grid that begins at 0 has a mean cosine of 1.2e-7.
TEST(Gaussians, HaveDirectionsWithoutABias) {
  double sum = 0;
  WideBits c{};
  for (std::uint32_t k = 0; k < 1u << 23; k += wide_count) {
    for (std::uint32_t lane = 0; lane < wide_count; ++lane)
      c[lane] = (k + lane) << 8;
    WideFloats const cosine = detail::HalfTurn(c).cosine();
    for (std::size_t lane = 0; lane < wide_count; ++lane)
      sum += cosine[lane];
  }
  EXPECT_NEAR(sum / (1u << 23), 0, 1e-9);
}

TEST(Gaussians, AgreeWithThePlainLibraryFunctions) {
  NoiseSource const source(987654321, Stream::fluctuation, 12345);
  std::uint32_t const pairs = 16 * 4096;
  auto const fast = many_gaussians(source, pairs);
  double worst = 0;
  std::size_t compared = 0;
  for (std::uint32_t k = 0; k < pairs; ++k) {
    auto const plain = gaussians_reference(source, k, 3 * k + 1);
    for (int d = 0; d < 3; ++d, ++compared)
      worst = std::max(worst, std::abs(fast[3 * k + d] - plain[d]));
  }
  EXPECT_EQ(compared, 3u * pairs);
  // Where u is near 1 its single-precision spacing of 6e-8 shows as sqrt(2 * 6e-8) in a radius near 0.
  EXPECT_LT(worst, 4e-4);
}

TEST(Gaussians, HaveTheMomentsAndTheLawOfAStandardGaussian) {
  auto const g = many_gaussians(NoiseSource(1, Stream::fluctuation, 0), 16 * 20000);
  double const n = static_cast<double>(g.size());
  ASSERT_EQ(g.size(), 960000u);
  double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
  for (double const x : g)
    m1 += x / n, m2 += x * x / n, m3 += x * x * x / n, m4 += x * x * x * x / n;
  EXPECT_LT(std::abs(m1), 4 * std::sqrt(1 / n));
  EXPECT_LT(std::abs(m2 - 1), 4 * std::sqrt(2 / n));
  EXPECT_LT(std::abs(m3), 4 * std::sqrt(15 / n));
  EXPECT_LT(std::abs(m4 - 3), 4 * std::sqrt(96 / n));
  auto cdf = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  EXPECT_GT(cg::kolmogorov_smirnov_p(g, cdf), 1e-3);
  EXPECT_LT(cg::kolmogorov_smirnov_p(g, [&](double x) { return cdf(x / 1.01); }), 1e-3); // 1 % too wide fails
}

TEST(Gaussians, AreTheReferenceInEveryLaneAndBringItsSpareBits) {
  NoiseSource const source(5, Stream::fluctuation, 77);
  NoiseLanes const lanes(source);
  WideBits a{}, b{};
  for (std::uint32_t lane = 0; lane < wide_count; ++lane)
    a[lane] = 4000000000u - lane, b[lane] = lane + 1000;
  GaussianLanes const together(lanes, a, b);
  for (std::size_t lane = 0; lane < wide_count; ++lane) {
    GaussianLanes const alone(lanes, a[lane] - WideBits{}, b[lane] - WideBits{});
    std::size_t const other = (lane + 5) % wide_count;
    EXPECT_EQ(alone.x[other], together.x[lane]);
    EXPECT_EQ(alone.y[other], together.y[lane]);
    EXPECT_EQ(alone.z[other], together.z[lane]);
    EXPECT_EQ(together.bits[lane], gaussians_and_bits_reference(source, a[lane], b[lane]).bits);
  }
}

TEST(Gaussians, AreTheFirstOfThreeWhereOneIsEnough) {
  NoiseLanes const lanes(NoiseSource(5, Stream::conduction, 78));
  WideBits a{}, b{};
  for (std::uint32_t lane = 0; lane < wide_count; ++lane)
    a[lane] = 7 * lane, b[lane] = 1000 - lane;
  GaussianLanes const three(lanes, a, b);
  OneGaussianLanes const one(lanes.generate(a, b));
  for (std::size_t lane = 0; lane < wide_count; ++lane) {
    EXPECT_EQ(one.x[lane], three.x[lane]);
    EXPECT_EQ(one.bits[lane], three.bits[lane]);
  }
}

TEST(Gaussians, DifferBetweenStepsStreamsAndSeeds) {
  auto const base = gaussians_reference(NoiseSource(1, Stream::fluctuation, 9), 4, 5);
  EXPECT_NE(base, gaussians_reference(NoiseSource(1, Stream::fluctuation, 10), 4, 5));
  EXPECT_NE(base, gaussians_reference(NoiseSource(1, Stream::fluctuation, 9 + (1ull << 32)), 4, 5));
  EXPECT_NE(base, gaussians_reference(NoiseSource(1, Stream::initial_velocities, 9), 4, 5));
  EXPECT_NE(base, gaussians_reference(NoiseSource(1 + (1ull << 40), Stream::fluctuation, 9), 4, 5));
}

} // namespace
} // namespace mesobridge::sdpd
