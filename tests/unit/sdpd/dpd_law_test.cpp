#include "sdpd/friction/dpd_law.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

PowerFriction const shape(4.5, 2, 1, 2);

// gamma = (sigma^2 / 4 k_B)(1/T_i + 1/T_j) with a sigma that does not know the temperatures (sdpd/README.md,
// Eq. (S13)), in numbers and in lanes.
TEST(DpdeLaw, FulfilsItsFluctuationDissipationRelation) {
  double const k_B = 0.7, a = 0.37;
  DpdeLaw<Transverse::none> const law{shape, k_B};
  std::vector<double> sigma2;
  for (double const T_i : {0.3, 1.0, 2.1})
    for (double const T_j : {0.6, 1.7}) {
      auto const bath = law.bath<double>({T_i, T_j, 0.1, 0.2});
      double const gamma = bath.gamma_over_a * a;
      sigma2.push_back(bath.thermal * gamma);
      EXPECT_NEAR(gamma, sigma2.back() / (4 * k_B) * (1 / T_i + 1 / T_j), 1e-14);
      auto const lanes = law.bath<FloatLanes>(
          {constant<FloatLanes>(T_i), constant<FloatLanes>(T_j), FloatLanes{}, FloatLanes{}});
      EXPECT_NEAR(lanes.gamma_over_a[2], bath.gamma_over_a, 1e-6 * bath.gamma_over_a);
      EXPECT_NEAR(lanes.thermal[7], bath.thermal, 1e-6 * bath.thermal);
    }
  ASSERT_EQ(sigma2.size(), 6u);
  for (double const each : sigma2)
    EXPECT_NEAR(each, 2 * k_B * a, 1e-14); // sigma^2 = 2 k_B T_0 gamma_0
}

TEST(DpdLaw, HasTheSetTemperature) {
  double const k_B = 0.7, a = 0.37;
  auto const bath = DpdLaw<Transverse::own>{shape, k_B}.bath<double>();
  EXPECT_NEAR(bath.thermal * bath.gamma_over_a * a, 2 * k_B * a, 1e-14);
  for (double const dt : {1e-3, 0.5, 20.0}) {
    auto const step = bath.step(a, dt);
    double const keep = 1 + step.decay;
    EXPECT_NEAR(step.variance / (1 - keep * keep), 2 * k_B, 1e-9); // <v^2> of a relative velocity
  }
}

TEST(FrictionShape, IsThePowerThatItSays) {
  EXPECT_NEAR(shape(0.25).par, 4.5 * 0.5625, 1e-14);
  EXPECT_NEAR(shape(0.25).perp, 2 * 0.5625, 1e-14);
  EXPECT_EQ(shape(1.25).par, 0);
  PowerFriction const root(3, 0, 2, 0.5);
  EXPECT_FALSE(root.has_across());
  int looked_at = 0;
  for (double r = 0.01; r < 2; r += 0.03, ++looked_at) {
    EXPECT_NEAR(root(r).par, 3 * std::sqrt(1 - r / 2), 1e-12);
    EXPECT_NEAR(root(constant<WideFloats>(r)).par[4], root(r).par, 1e-6);
    EXPECT_NEAR(shape(constant<WideFloats>(r)).perp[11], shape(r).perp, 1e-6);
  }
  EXPECT_EQ(root(constant<WideFloats>(2.5)).par[1], 0);
  EXPECT_GT(looked_at, 60);
  auto const scaled = shape.in_units(2, 3);
  EXPECT_NEAR(scaled(0.1).par, shape(0.2).par / 3, 1e-14);
}

TEST(FrictionShape, OfATableIsTheTable) {
  std::vector<double> const r{0.1, 0.4, 0.8, 1.2, 1.5}, par{5, 4, 2, 0.5, 0}, perp{2, 0, 0, 1, 0};
  TabulatedFriction const table(r, par, perp);
  EXPECT_TRUE(table.has_across());
  EXPECT_EQ(table.cutoff(), 1.5);
  for (std::size_t k = 0; k < r.size() - 1; ++k) {
    EXPECT_NEAR(table(r[k]).par, par[k], 1e-5);
    EXPECT_NEAR(table(r[k]).perp, perp[k], 1e-5);
  }
  EXPECT_NEAR(table(0.01).par, 5, 1e-14); // constant inside the first point
  EXPECT_EQ(table(1.6).par, 0);
  for (double x = 0.02; x < 1.5; x += 0.01) {
    EXPECT_GE(table(x).perp, 0);
    auto const wide = table(constant<WideFloats>(x));
    EXPECT_NEAR(wide.par[6], table(x).par, 1e-6);
    EXPECT_NEAR(wide.perp[15], table(x).perp, 1e-6);
  }
  EXPECT_FALSE(TabulatedFriction(r, par, {}).has_across());
  EXPECT_THROW(TabulatedFriction(r, {5, 4, -1, 0, 0}, {}), InputError);
  EXPECT_THROW(TabulatedFriction({0, 1, 1}, {1, 1, 0}, {}), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
