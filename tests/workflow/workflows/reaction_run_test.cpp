#include "scratch_directory.hpp"
#include "sdpd_scene.hpp"
#include "workflows/json_file.hpp"
#include "workflows/process.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numeric>

// A fluid that burns, from the scene to its files.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

std::string const burning = tests::burning_scene(R"(steps = 64
sample_every = 2
trajectory_every = 30
checkpoint_every = 30
[profile]
axis = "z"
bins = 4
every = 20
[histogram]
every = 20
quantities = ["progress"] # the others are the same for all at the start
)")
                                .text();

ProcessResult ran(std::filesystem::path const& folder, std::string const& name,
                  std::vector<std::string> const& settings = {}) {
  auto const scene = folder / "burning.toml";
  write_text_file(scene, burning);
  std::vector<std::string> words{
      MESOBRIDGE_PROGRAM,      "run", scene.string(), "--quiet", "--json", "--threads", "1", "-o",
      (folder / name).string()};
  for (auto const& setting : settings)
    words.insert(words.end(), {"--set", setting});
  return run_process(words);
}

TEST(ReactionRun, WritesTheProgressEverywhere) {
  ScratchDirectory const scratch;
  auto const done = ran(scratch.path(), "run");
  ASSERT_TRUE(done.status == 0 || done.status == 3) << done.errors;
  Store const store(scratch / "run" / "run.h5", Store::Mode::read);
  auto const summary = read_json(scratch / "run" / "summary.json");
  double const at_end = summary["progress"].get<double>();
  EXPECT_GT(at_end, 0.35);
  EXPECT_LT(at_end, 1);
  EXPECT_LT(std::abs(summary["energy_drift_per_reduced_time"].get<double>()), 1e-3);
  EXPECT_NE(read_text_file(scratch / "run" / "log.txt").find("progress"), std::string::npos);
  Store const checkpoint(scratch / "run" / "checkpoint.h5", Store::Mode::read);
  auto const progress = checkpoint.read_doubles("progress");
  EXPECT_NEAR(std::accumulate(progress.begin(), progress.end(), 0.0) / 512, at_end, 1e-12);
  EXPECT_EQ(store.read_doubles("profile/progress").size(), 4u * 4);
  auto const counts = store.read_integers("histogram/progress/counts"),
             above = store.read_integers("histogram/progress/above");
  ASSERT_EQ(counts.size(), 4u * 50); // from 0 to 1, so that all particles are in it
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}), 4 * 512);
  EXPECT_EQ(above, (std::vector<std::int64_t>{0, 0, 0, 0}));
}

// The fluid before the wall is compressed twice, by more than products of a trace stand.
TEST(ReactionRun, ADetonationMayRunIntoAWall) {
  ScratchDirectory const scratch;
  auto const result = run_process(
      {MESOBRIDGE_PROGRAM, "run", MESOBRIDGE_SOURCE_DIR "/workflows/scenes/detonation-nitromethane.toml",
       "--quiet", "--threads", "1", "-o", (scratch / "run").string(), "--set",
       "box.size=[\"14.66 nm\", \"14.66 nm\", \"80 nm\"]", "--set", "run.steps=700"});
  EXPECT_EQ(result.errors.find("mixture of progress"), std::string::npos) << result.errors;
  ASSERT_TRUE(std::filesystem::exists(scratch / "run" / "summary.json")) << result.errors;
  auto const summary = read_json(scratch / "run" / "summary.json");
  EXPECT_GT(summary["progress"].get<double>(), 0.99);
  EXPECT_LT(std::abs(summary["energy_balance_error"].get<double>()), 3e-3);
}

TEST(ReactionRun, EndsWithTheCauseWhereNoMixtureIs) {
  ScratchDirectory const scratch;
  auto const done = ran(scratch.path(), "run", {"fluid.rho=600 kg/m^3", "reaction.progress=0.9"});
  EXPECT_EQ(done.status, 3) << done.errors;
  EXPECT_NE(done.errors.find("mixture of progress"), std::string::npos) << done.errors;
}

} // namespace
} // namespace mesobridge::workflows
