#include "sdpd/kinetics/arrhenius.hpp"
#include "sdpd/simd/lane_math.hpp"
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <vector>

namespace mesobridge::sdpd {
namespace {

Lanes lanes(double first, double ratio) {
  Lanes x;
  for (std::size_t l = 0; l < lane_count; ++l, first *= ratio)
    x[l] = first;
  return x;
}

/// 0, 1, 2 ... as rows of so many quantities: `load(row of a lane)` makes lanes of each quantity.
template <class Number>
auto expect_quantities_of_rows(std::size_t lane_count, std::size_t quantity_count, auto const& load) {
  std::vector<Number> numbers(lane_count * quantity_count);
  std::iota(numbers.begin(), numbers.end(), Number{0});
  auto const quantities = load([&](std::size_t l) { return &numbers[quantity_count * l]; });
  for (std::size_t q = 0; q < quantity_count; ++q)
    for (std::size_t l = 0; l < lane_count; ++l)
      EXPECT_EQ(quantities[q][l], static_cast<Number>(quantity_count * l + q));
  return quantities;
}

TEST(Lanes, TurnRowsIntoQuantitiesAndBack) {
  auto const quantities =
      expect_quantities_of_rows<double>(lane_count, 4, [](auto const& row) { return load_rows(row); });
  auto const rows = to_rows(quantities);
  for (std::size_t l = 0; l < lane_count; ++l)
    for (std::size_t q = 0; q < 4; ++q)
      EXPECT_EQ(rows[l][q], static_cast<double>(4 * l + q));
}

TEST(WideLanes, TurnRowsIntoQuantities) {
  expect_quantities_of_rows<float>(wide_count, 4, [](auto const& row) { return load_wide_rows(row); });
}

TEST(Lanes, TurnLinesIntoQuantities) {
  expect_quantities_of_rows<double>(lane_count, 8, [](auto const& line) { return load_lines(line); });
}

TEST(Lanes, CompressKeepsWhatIsMarkedInItsOrder) {
  std::array<std::uint32_t, lane_count> const values{10, 11, 12, 13, 14, 15, 16, 17};
  Lanes const numbers = lanes(1, 2);
  int checked = 0;
  for (unsigned bits = 0; bits < 256; ++bits, ++checked) {
    std::array<std::uint32_t, lane_count> kept;
    std::array<double, lane_count> kept_numbers;
    compress(bits, values.data(), kept.data());
    compress(bits, numbers, kept_numbers.data());
    std::size_t count = 0;
    for (std::size_t l = 0; l < lane_count; ++l)
      if (bits >> l & 1u) {
        EXPECT_EQ(kept[count], values[l]);
        EXPECT_EQ(kept_numbers[count], numbers[l]);
        ++count;
      }
  }
  EXPECT_EQ(checked, 256);
}

TEST(Lanes, CompareWithoutTakingNaNForLess) {
  Lanes a = lanes(1, 2);
  a[3] = std::nan("");
  EXPECT_EQ(less(a, broadcast(20)), 0b00010111u); // 1 2 4 NaN 16
}

TEST(Lanes, HaveRootsToRoundOff) {
  int checked = 0;
  for (double x = 1e-280; x < 1e280; x *= 1e7, ++checked) {
    Lanes const at = lanes(x, 1.3), root = square_root(at), inverse = inverse_square_root(at);
    for (std::size_t l = 0; l < lane_count; ++l) {
      EXPECT_EQ(root[l], std::sqrt(at[l]));
      EXPECT_NEAR(inverse[l] * std::sqrt(at[l]), 1, 1e-15);
    }
  }
  EXPECT_GE(checked, 80);
}

TEST(Lanes, DistanceOfTwoParticlesInOnePlaceIsANumber) {
  DistanceLanes const distance(lanes(0, 1));
  EXPECT_LT(distance.r[0], 1e-140);
  EXPECT_EQ(0 * distance.inverse_r[0], 0);
}

TEST(WideLanes, HaveDistancesToSinglePrecision) {
  int checked = 0;
  for (float r2 = 1e-29f; r2 < 1e30f; r2 *= 1.37f, ++checked) {
    WideDistances const distance(r2 - WideFloats{});
    double const r = std::sqrt(double{r2});
    EXPECT_NEAR(distance.r[7] / r, 1, 2e-7) << r2;
    EXPECT_NEAR(distance.inverse_r[7] * r, 1, 2e-7) << r2;
  }
  EXPECT_GT(checked, 400);
  WideDistances const in_one_place(WideFloats{});
  EXPECT_LT(in_one_place.r[0], 1e-14);
  EXPECT_EQ(0 * in_one_place.inverse_r[0], 0);
}

TEST(MinusExpm1, IsRightToSinglePrecisionInLanes) {
  int checked = 0;
  double worst = 0;
  for (double x = 1e-30; x < 300; x *= 1.03, ++checked) {
    float const argument = static_cast<float>(x);
    FloatLanes const result = minus_expm1(constant<FloatLanes>(x));
    worst = std::max(worst, std::abs(result[5] / std::expm1(-double{argument}) - 1));
  }
  EXPECT_GT(checked, 2000);
  EXPECT_LT(worst, 2.5e-7);
  EXPECT_EQ(minus_expm1(FloatLanes{})[0], 0);
}

TEST(MinusExpm1, IsRightToRoundOffInLanes) {
  int checked = 0;
  double worst = 0;
  for (double x = 1e-300; x < 1e6; x *= 1.37, ++checked) {
    Lanes const at = lanes(x, 1.043), result = minus_expm1(at);
    for (std::size_t l = 0; l < lane_count; ++l)
      worst = std::max(worst, std::abs(result[l] / std::expm1(-at[l]) - 1));
  }
  EXPECT_GT(checked, 2000);
  EXPECT_LT(worst, 1e-15);
  EXPECT_EQ(minus_expm1(Lanes{})[0], 0);
}

TEST(Logarithm, IsRightToRoundOffInLanes) {
  int checked = 0;
  for (double x = 1e-300; x < 1e300; x *= 1.7, ++checked) {
    Lanes const at = lanes(x, 1.0321), log = logarithm(at);
    for (std::size_t l = 0; l < lane_count; ++l)
      EXPECT_NEAR(log[l], std::log(at[l]), 3e-16 * std::max(1.0, std::abs(std::log(at[l])))) << at[l];
  }
  EXPECT_GT(checked, 2500);
  for (double const d : {1e-3, 1e-8, 1e-13}) // near 1 the error must be small beside the result
    EXPECT_NEAR(logarithm(broadcast(1 + d))[3] / std::log1p((1 + d) - 1), 1, 1e-15);
}

TEST(LogarithmOfFloats, IsRightToSinglePrecision) {
  int checked = 0;
  for (float x = 1.2e-38f; x < 1e38f; x *= 1.0173f, ++checked) {
    double const exact = std::log(double{x});
    EXPECT_NEAR(logarithm(x - WideFloats{})[5], exact, 1.5e-7 * std::max(1.0, std::abs(exact))) << x;
  }
  EXPECT_GT(checked, 10000);
  for (float const d : {1e-2f, -1e-2f, 1e-5f, -1e-5f}) // near 1 the error must be small beside the result
    EXPECT_NEAR(logarithm((1 + d) - WideFloats{})[3] / std::log(double{1 + d}), 1, 3e-7) << d;
}

TEST(ExpUpToOne, IsRightToSinglePrecision) {
  int checked = 0;
  for (double x = -70; x < 2; x += 0.0137, ++checked)
    EXPECT_NEAR(exp_up_to_one(constant<FloatLanes>(x))[2], std::exp(std::min(x, 0.0)), 1.2e-7);
  EXPECT_GT(checked, 5000);
}

TEST(Exponentials, LeaveANaNOne) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(minus_expm1(constant<FloatLanes>(nan))[0]));
  EXPECT_TRUE(std::isnan(minus_expm1(constant<WideFloats>(nan))[0]));
  EXPECT_TRUE(std::isnan(minus_expm1(broadcast(nan))[0]));
  EXPECT_TRUE(std::isnan(exp_up_to_one(constant<FloatLanes>(nan))[0]));
  EXPECT_TRUE(std::isnan((Arrhenius{1, 1})(broadcast(nan))[0]));
}

} // namespace
} // namespace mesobridge::sdpd
