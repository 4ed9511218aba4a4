#include "md/error.hpp"
#include "sdpd_scene.hpp"
#include "workflows/scene/tolerance.hpp"
#include "workflows/study/automatic_dt.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

TEST(Tolerance, ReadsRatesAndShares) {
  EXPECT_DOUBLE_EQ(parse_rate("1e-6/ps", UnitSystem::SI), 1e6);
  EXPECT_DOUBLE_EQ(parse_rate("2 / ns", UnitSystem::SI), 2e9);
  EXPECT_DOUBLE_EQ(parse_rate("1e-6", UnitSystem::lj), 1e-6);
  EXPECT_DOUBLE_EQ(parse_share("0.5%"), 0.005);
  EXPECT_DOUBLE_EQ(parse_share("0.5 %"), 0.005);
  EXPECT_DOUBLE_EQ(parse_share("0.01"), 0.01);
  int refused = 0;
  for (char const* text : {"1e-6", "ps", "", "-1/ps", "0/ps", "1/K", "1 ps", "nan/ps"}) {
    EXPECT_THROW(parse_rate(text, UnitSystem::SI), InputError) << text;
    ++refused;
  }
  for (char const* text : {"", "0", "1", "150%", "-1%", "0.1 m", "nan"}) {
    EXPECT_THROW(parse_share(text), InputError) << text;
    ++refused;
  }
  EXPECT_THROW(parse_rate("1/ps", UnitSystem::lj), InputError);
  EXPECT_EQ(refused, 15);
}

std::string scene_text(std::string const& scheme) {
  return tests::SdpdScene{.scheme = scheme}.text();
}

TEST(Tolerance, BelongsToAnAutomaticTimeStep) {
  auto const scene = parse_scene(scene_text("dt = \"auto\"\ndrift = \"1e-6/ps\"\n"), "s.toml");
  EXPECT_TRUE(scene.scheme.dt.automatic);
  EXPECT_EQ(tolerance_text(scene.scheme), "drift 1e-6/ps");
  EXPECT_EQ(parse_scene(resolved_toml(scene), "r.toml"), scene);
  auto const three = parse_scene(
      scene_text("dt = \"auto\"\ndynamics = \"5%\"\nbias = \"1%\"\ndrift = \"1e-6/ps\"\n"), "s.toml");
  EXPECT_EQ(tolerance_text(three.scheme), "drift 1e-6/ps, bias 1%, dynamics 5%");
  struct Case {
    char const *scheme, *message;
  };
  int refused = 0;
  for (auto const& [scheme, message] :
       {Case{"dt = \"auto\"\n", "needs a tolerance"}, Case{"dt = 0.1\nbias = \"1%\"\n", "wants dt"},
        Case{"dt = \"auto\"\ndrift = \"1e-6\"\n", "per unit of time"},
        Case{"dt = \"auto\"\ndynamics = \"5\"\n", "must be a share"},
        Case{"dt = 0.1\ndynamics = \"5%\"\n", "wants dt"},
        Case{"dt = \"auto\"\ndynamics = \"5%\"\nconservative = \"none\"\n", "nothing diffuses"},
        Case{"dt = \"Auto\"\n", "scheme.dt"}}) {
    try {
      parse_scene(scene_text(scheme), "s.toml");
      ADD_FAILURE() << scheme;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
    ++refused;
  }
  EXPECT_EQ(refused, 7);
}

TEST(Tolerance, StaysWithTheTimeStepThatWasChosenForIt) {
  auto const scene = parse_scene(scene_text("dt = \"auto\"\ndrift = \"1e-6/ps\"\n"), "s.toml");
  auto stored = scene;
  stored.scheme = {.dt = {.value = 0.12},
                   .dt_chosen_for = "drift 1e-6/ps",
                   .diffusion_share = 0.3,
                   .diffusion_share_se = 0.02};
  auto const chosen = with_stored_time_step(scene, stored);
  EXPECT_EQ(chosen, stored);
  EXPECT_EQ(parse_scene(resolved_toml(chosen), "r.toml"), chosen);
  stored.scheme.dt_chosen_for = "bias 1%";
  EXPECT_THROW(with_stored_time_step(scene, stored), InputError);
}

} // namespace
} // namespace mesobridge::workflows
