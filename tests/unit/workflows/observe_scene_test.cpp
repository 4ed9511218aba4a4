#include "scene_error.hpp"
#include "sdpd_scene.hpp"
#include "soft_scene.hpp"
#include "workflows/scene/scene.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::error_of, tests::replaced;

std::string const sdpd = tests::SdpdScene{.run = R"(steps = 1000
[profile]
axis = "z"
bins = 24
every = 50
quantities = ["velocity", "P"]
[histogram]
every = 100
)"}
                             .text();

std::string const dpd =
    tests::SoftScene{
        .method = "dpd", .N = 1000, .run = "steps = 1000\n[profile]\nevery = 10\n", .potential = ""}
        .text();

TEST(ObserveScene, ReadsItsTablesAndReadsBackAsTheSame) {
  auto const scene = parse_scene(sdpd, "s.toml");
  EXPECT_EQ(scene.profile.axis, "z");
  EXPECT_EQ(scene.profile.bins, 24);
  EXPECT_EQ(scene.profile.quantities, (std::vector<std::string>{"velocity", "P"}));
  EXPECT_TRUE(scene.histogram.quantities.empty());
  EXPECT_EQ(parse_scene(resolved_toml(scene), "r.toml"), scene);
  auto const other = parse_scene(sdpd, "s.toml", {"profile.quantities=[\"rho\"]", "profile.every=0"});
  EXPECT_EQ(other.profile.quantities, std::vector<std::string>{"rho"});
  EXPECT_NO_THROW(parse_scene(dpd, "d.toml"));
}

TEST(ObserveScene, RefusesWhatCannotBeObserved) {
  struct Case {
    std::string text;
    std::vector<std::string> message;
  };
  std::vector<Case> const cases{
      {replaced(sdpd, "\"z\"", "\"w\""), {"bad.toml:16", "profile.axis", "\"x\", \"y\", \"z\""}},
      {replaced(sdpd, "bins = 24", "bins = 0"), {"profile.bins", "from 1"}},
      {replaced(sdpd, "\"P\"]", "\"p\"]"), {"profile.quantities", "a list of some of", "P_internal"}},
      {replaced(sdpd, "\"velocity\", \"P\"", "\"P\", \"P\""), {"profile.quantities", "once"}},
      {replaced(sdpd, "[\"velocity\", \"P\"]", "\"P\""), {"profile.quantities", "a list of some of"}},
      {replaced(sdpd, "[\"velocity\", \"P\"]", "[1]"), {"profile.quantities", "a list of some of"}},
      {replaced(sdpd, "every = 50", "every = 2000"), {"profile.every", "run.steps = 1000"}},
      {replaced(sdpd, "every = 50", "evry = 50"), {"evry", "every"}},
      {replaced(dpd, "every = 10", "quantities = [\"T_int\"]"), {"T_int", "there are: rho, velocity, T_kin"}},
      {dpd + "[histogram]\nevery = 10\n", {"histogram.every", "none of the quantities"}},
  };
  int ran = 0;
  for (auto const& [text, parts] : cases) {
    auto const error = error_of(text);
    for (auto const& part : parts)
      EXPECT_NE(error.find(part), std::string::npos) << error;
    ++ran;
  }
  EXPECT_EQ(ran, 10);
}

} // namespace
} // namespace mesobridge::workflows
