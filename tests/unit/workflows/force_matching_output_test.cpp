#include "workflows/coarse/force_matching_output.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

TEST(ForceMatchOutput, WarnsOfErrorsThatGrowAndOfAnAttractiveCore) {
  ForcesOfFile const data{};
  PotentialTrial const trial{};
  std::optional<PotentialBeside> const none;
  auto const warnings = [&](double core, double longer) {
    cg::MatchedForce found{};
    found.f = {{core, 0.1, 16}, {-1, 0.1, 16}}, found.longer_blocks = longer;
    return force_match_warnings({data, found, trial, none});
  };
  EXPECT_TRUE(warnings(2, 1.2).empty());
  ASSERT_EQ(warnings(2, 1.8).size(), 1u);
  EXPECT_NE(warnings(2, 1.8)[0].find("1.8 times"), std::string::npos);
  ASSERT_EQ(warnings(-2, 1.2).size(), 1u);
  EXPECT_NE(warnings(-2, 1.2)[0].find("attracts"), std::string::npos);
}

} // namespace
} // namespace mesobridge::workflows
