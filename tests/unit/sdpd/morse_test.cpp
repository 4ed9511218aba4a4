#include "sdpd/potential/list.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

// Values on paper: the depth, no force at the minimum, u = 0 where x = 2, and the curvature 2 epsilon
// alpha^2.
TEST(Morse, HasItsTextbookValues) {
  double const epsilon = 3, r_m = 1.2, width = 0.25, cutoff = 30; // so far that nothing is left to shift by
  Morse const morse(epsilon, r_m, width, cutoff);
  EXPECT_NEAR(morse(r_m, 1 / r_m).energy, -epsilon, 1e-12);
  EXPECT_NEAR(morse(r_m, 1 / r_m).strength, 0, 1e-12);
  double const zero = r_m - width * std::log(2.0);
  EXPECT_NEAR(morse(zero, 1 / zero).energy, 0, 1e-12);
  double const d = 1e-4, force = morse(r_m + d, 1 / (r_m + d)).strength * (r_m + d);
  EXPECT_NEAR(-force / d, 2 * epsilon / (width * width), 1e-3 * 2 * epsilon / (width * width));
}

} // namespace
} // namespace mesobridge::sdpd
