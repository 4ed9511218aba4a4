#include "workflows/sdpd/duct_flow.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

// Shah and London 1978, Laminar Flow Forced Convection in Ducts: f Re = D^2/2U in these units, D = 2ab/(a +
// b), is 14.22708 in a square, where the velocity on the axis is 2.0962 times the mean one, and 15.54806 in a
// duct of 1 : 2. A very wide one is a gap between two planes.
TEST(Duct, HasThePublishedVelocities) {
  Duct const square{1, 1};
  EXPECT_NEAR(0.5 / square.mean_velocity(), 14.22708, 1e-4);
  EXPECT_NEAR(square.velocity(0.5, 0.5) / square.mean_velocity(), 2.0962, 1e-4);
  EXPECT_NEAR((8.0 / 9 / Duct{1, 2}.mean_velocity()), 15.54806, 1e-4);
  EXPECT_NEAR((Duct{1, 400}.mean_velocity()), 1.0 / 12, 2e-4);
  EXPECT_NEAR((Duct{1, 400}.velocity(0.3, 200)), 0.3 * 0.7 / 2, 1e-6);
}

TEST(Duct, FulfilsItsEquationAndDoesNotSlip) {
  Duct const duct{2, 3};
  double const h = 1e-3;
  int compared = 0;
  for (double const z : {0.4, 1.0, 1.7})
    for (double const y : {0.5, 1.5, 2.2}) {
      double const here = duct.velocity(z, y);
      double const laplacian = (duct.velocity(z + h, y) + duct.velocity(z - h, y) + duct.velocity(z, y + h) +
                                duct.velocity(z, y - h) - 4 * here) /
                               (h * h);
      EXPECT_NEAR(laplacian, -1, 1e-2);
      ++compared;
    }
  EXPECT_EQ(compared, 9);
  EXPECT_NEAR(duct.velocity(0, 1), 0, 1e-5);
  EXPECT_NEAR(duct.velocity(1, 3), 0, 1e-5);
}

// The friction on the walls carries the whole force on the fluid; it misses 4e-3 of it where the series of
// cosines alone ends at its 199th, whose slope at the walls goes on.
TEST(Duct, RubsAtItsWallsAsHardAsItIsDriven) {
  Duct const duct{2, 3}, turned{3, 2};
  double const h = 1e-4;
  double const on_z = 2 * duct.b * duct.velocity(h) / h, on_y = 2 * duct.a * turned.velocity(h) / h;
  EXPECT_NEAR((on_z + on_y) / (duct.a * duct.b), 1, 3e-4); // over h the profile bends a little
}

TEST(Duct, HasTheMeansOfItsVelocities) {
  Duct const duct{2, 3};
  double over_y = 0, over_both = 0;
  constexpr int n = 300;
  for (int k = 0; k < n; ++k) {
    over_y += duct.velocity(0.6, (k + 0.5) * duct.b / n) / n;
    over_both += duct.velocity((k + 0.5) * duct.a / n) / n;
  }
  EXPECT_NEAR(over_y / duct.velocity(0.6), 1, 1e-4);
  EXPECT_NEAR(over_both / duct.mean_velocity(), 1, 1e-4);
  EXPECT_NEAR((Duct{3, 2}.mean_velocity()) / duct.mean_velocity(), 1, 1e-6);
}

} // namespace
} // namespace mesobridge::workflows
