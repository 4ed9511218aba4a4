#include "sdpd/friction/sdpd_friction.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

// sigma and gamma by sdpd/README.md, Eq. (S15), beside the step's coefficients for a short time.
TEST(PairBath, GivesItsFrictionAndNoise) {
  double const kB = 0.02, T_i = 1.3, T_j = 0.8, C_i = 1.4, C_j = 1.7, a = 0.37, dt = 1e-7;
  double const d = kB * T_i * T_j / ((T_i + T_j) * (T_i + T_j)) * (1 / C_i + 1 / C_j);
  double const gamma = a * (1 - d);
  double const sigma2 = 4 * gamma / (1 - d) * kB * T_i * T_j / (T_i + T_j);
  auto const step = PairBath<double>(kB, T_i, T_j, 1 / C_i, 1 / C_j).step(a, dt);
  EXPECT_NEAR(-step.decay / dt, 2 * gamma, 1e-6 * gamma);     // dv = -2 gamma v dt at m = 1
  EXPECT_NEAR(step.variance / dt, 4 * sigma2, 1e-6 * sigma2); // both particles are kicked by sigma
}

// With constant sigma, gamma of Eq. (S16) is (sigma^2/4)[(1/k_B - 1/C_i)/T_i + (1/k_B - 1/C_j)/T_j]; with
// the sigma of Eq. (S15), which depends on the energies, the general form must give its friction back. The
// derivative is taken numerically: an independent way to the same friction.
TEST(PairBath, FulfilsTheGeneralFluctuationDissipationRelation) {
  double const kB = 0.05, C_i = 1.2, C_j = 1.9, a = 0.9;
  auto sigma2_over_TT = [&](double e_i, double e_j) { // T = e/C
    double const T_i = e_i / C_i, T_j = e_j / C_j;
    return 4 * a * kB / (T_i + T_j);
  };
  double const e_i = 1.5, e_j = 1.1, T_i = e_i / C_i, T_j = e_j / C_j, h = 1e-5;
  double const slope = (sigma2_over_TT(e_i + h, e_j + h) - sigma2_over_TT(e_i - h, e_j - h)) / (2 * h);
  double const gamma =
      0.25 * (T_i * T_j * slope + sigma2_over_TT(e_i, e_j) * T_i * T_j / kB * (1 / T_i + 1 / T_j));
  EXPECT_NEAR(a * PairBath<double>(kB, T_i, T_j, 1 / C_i, 1 / C_j).gamma_over_a, gamma, 1e-8);
}

TEST(PairBath, LeavesTheEquilibriumVarianceOfTheVelocityAlone) {
  double const kB = 0.1, T = 1.7, huge_C = 1e12;
  for (double const dt : {1e-4, 0.1, 1.0, 30.0}) {
    auto const step = PairBath<double>(kB, T, T, 1 / huge_C, 1 / huge_C).step(0.6, dt);
    double const keep = 1 + step.decay;
    EXPECT_NEAR(step.variance / (1 - keep * keep), 2 * kB * T, 1e-9); // <v^2> of a relative velocity
  }
}

TEST(SdpdFriction, RefusesABulkViscosityAboveFiveThirdsOfTheShearViscosity) {
  EXPECT_NO_THROW(SdpdFriction(1, 5.0 / 3 - 1e-9));
  EXPECT_THROW(SdpdFriction(1, 1.7), InputError);
  EXPECT_THROW(SdpdFriction(-1, 0), InputError);
  EXPECT_THROW(SdpdFriction(std::nan(""), 0), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
