#include "cg/distribution_error.hpp"
#include "sdpd/observe/gamma_law.hpp"
#include "sdpd/setup/trial.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

TEST(Trial, JudgesByTheBetterKnownDriftUnlessTheyDisagree) {
  TrialResult result;
  result.drift_of_mean = {1e-6, 5e-7}, result.drift_of_walk = {8e-7, 1e-7};
  EXPECT_EQ(result.drift().rate, 8e-7);
  result.drift_of_mean = {1e-5, 5e-7};
  EXPECT_EQ(result.drift().rate, 1e-5);
  result.drift_of_walk = {};
  EXPECT_EQ(result.drift().rate, 1e-5);
}

TEST(Distribution, HasTheGammaLawAndItsDistance) {
  cg::Bins const bins{.lower = 0, .upper = 40, .count = 400};
  auto const law = gamma_law(5, bins);
  double sum = 0, mean = 0;
  for (std::size_t b = 0; b < bins.count; ++b) {
    sum += law[b] * bins.width();
    mean += law[b] * bins.width() * (static_cast<double>(b) + 0.5) * bins.width();
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(mean, 6, 1e-3); // C_K = (3/2)(K - 1)
  EXPECT_EQ(cg::distribution_error(law, law), 0);
  EXPECT_NEAR(cg::distribution_error(std::vector<double>(bins.count, 0.0), law), 1, 1e-12);
}

} // namespace
} // namespace mesobridge::sdpd
