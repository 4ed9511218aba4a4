#include "scratch_directory.hpp"
#include "unit/workflows/killed_process.hpp"
#include "workflows/process.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <random>
#include <sys/wait.h>
#include <thread>

// A run that is killed again and again, at any time and in the hardest way, and resumed each time, ends with
// the same bits as one that was left alone. It writes often, so that many of its deaths are in the middle of
// that; undo_journal_test.cpp goes through all of them.

namespace mesobridge::workflows {
namespace {

using tests::killed;
using tests::killed_after;
using tests::ScratchDirectory;

std::vector<std::string> words(std::filesystem::path const& directory, bool resume) {
  std::vector<std::string> result{MESOBRIDGE_PROGRAM,
                                  "run",
                                  MESOBRIDGE_SOURCE_DIR "/workflows/scenes/ideal-gas.toml",
                                  "-o",
                                  directory.string(),
                                  "--quiet",
                                  "--threads",
                                  "1"};
  for (char const* set :
       {"particles.N=343", "particles.density=plain", "run.equilibrate=64", "run.steps=2500",
        "run.sample_every=5", "run.trajectory_every=20", "run.vtkhdf_every=20", "run.xyz_every=100",
        "profile.every=20", "histogram.every=50", "series.every=25", "run.checkpoint_every=100"})
    result.insert(result.end(), {"--set", set});
  if (resume)
    result.push_back("--resume");
  return result;
}

std::vector<std::vector<double>> datasets(std::filesystem::path const& file,
                                          std::vector<std::string> const& names) {
  Store const store(file, Store::Mode::read);
  std::vector<std::vector<double>> result;
  for (auto const& name : names)
    result.push_back(store.read_doubles(name));
  return result;
}

void kill_and_compare(int wanted, unsigned seed) {
  ScratchDirectory const scratch;
  auto const unbroken = scratch / "unbroken", broken = scratch / "broken";
  auto const whole = run_process(words(unbroken, false));
  ASSERT_EQ(whole.status, 0) << whole.errors;
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> delay(1000, 150000); // us
  int kills = 0, ends = 0;
  for (int attempt = 0; kills < wanted && attempt < 3 * wanted; ++attempt) {
    int const signal = attempt % 2 == 0 ? SIGKILL : SIGTERM;
    bool const begun = std::filesystem::exists(broken / "scene.toml");
    int const status =
        killed_after(std::chrono::microseconds(delay(generator)), signal, words(broken, begun));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
      ++ends; // it was done before
    else if (WIFSIGNALED(status))
      ++kills;
    else {
      ASSERT_EQ(WEXITSTATUS(status), 130); // SIGTERM: a checkpoint was written
      ++kills;
    }
  }
  EXPECT_EQ(kills, wanted) << ends;
  auto const last = run_process(words(broken, true));
  ASSERT_EQ(last.status, 0) << last.errors;
  std::vector<std::string> const results{"thermodynamics",
                                         "moments",
                                         "particles/eps",
                                         "particles/rho",
                                         "particles/P",
                                         "profile/P_Pa",
                                         "profile/velocity_m_s",
                                         "profile/time_s",
                                         "histogram/eps_J/counts",
                                         "series/time_s",
                                         "series/compression_response",
                                         "histogram/rho_kg_m3/edges"},
      frames{"particles/trajectory/position/value", "particles/trajectory/velocity/value",
             "particles/trajectory/position/step", "particles/trajectory/velocity/time",
             "particles/trajectory/box/edges/value"},
      vtk_frames{"VTKHDF/Points",       "VTKHDF/PointData/velocity", "VTKHDF/PointData/rho_kg_m3",
                 "VTKHDF/Steps/Values", "VTKHDF/Steps/PointOffsets", "mesobridge/step"};
  auto const expected = datasets(unbroken / "run.h5", results);
  ASSERT_EQ(expected[0].size(), 501u * 12u);
  EXPECT_TRUE(expected == datasets(broken / "run.h5", results));
  EXPECT_TRUE(datasets(unbroken / "trajectory.h5md", frames) == datasets(broken / "trajectory.h5md", frames));
  auto const points = datasets(unbroken / "trajectory.vtkhdf", vtk_frames);
  ASSERT_EQ(points[0].size(), 126u * 343u * 3u);
  EXPECT_TRUE(points == datasets(broken / "trajectory.vtkhdf", vtk_frames));
  EXPECT_EQ(read_text_file(unbroken / "trajectory.xyz"), read_text_file(broken / "trajectory.xyz"));
  EXPECT_EQ(read_text_file(unbroken / "summary.json"), read_text_file(broken / "summary.json"));
  EXPECT_EQ(read_text_file(unbroken / "scene.toml"), read_text_file(broken / "scene.toml"));
}

TEST(KilledRun, EndsWithTheBitsOfAnUnbrokenOne) {
  kill_and_compare(20, 20);
}

TEST(Long_KilledRun, EndsWithTheBitsOfAnUnbrokenOne) {
  for (int run = 0; run < 5; ++run)
    kill_and_compare(20, 100 + static_cast<unsigned>(run));
}

TEST(KilledRun, OfIsolatedStarsEndsWithTheBitsOfAnUnbrokenOne) {
  ScratchDirectory const scratch;
  auto const command = [](std::filesystem::path const& directory, bool resume) {
    std::vector<std::string> words{MESOBRIDGE_PROGRAM, "md", "star-vacuum", "--star", "3-2", "--ranks", "1"};
    words.insert(words.end(), {"--molecules", "48", "--equilibration-steps", "500", "--sampling-steps",
                               "6000", "--redraw-every", "90", "--sample-every", "40", "--checkpoint-every",
                               "500", "--quiet", "-o", directory.string()});
    if (resume)
      words.emplace_back("--resume");
    return words;
  };
  auto const unbroken = scratch / "unbroken", broken = scratch / "broken";
  auto const whole = run_process(command(unbroken, false));
  ASSERT_EQ(whole.status, 0) << whole.errors;
  std::mt19937 generator(21);
  std::uniform_int_distribution<int> delay(1000, 300000); // us
  int kills = 0;
  constexpr int wanted = 8;
  for (int attempt = 0; kills < wanted && attempt < 3 * wanted; ++attempt)
    kills += WIFSIGNALED(killed_after(std::chrono::microseconds(delay(generator)), SIGKILL,
                                      command(broken, std::filesystem::exists(broken / "vacuum.restart"))));
  EXPECT_GE(kills, wanted / 2);
  auto const last = run_process(command(broken, std::filesystem::exists(broken / "vacuum.restart")));
  ASSERT_EQ(last.status, 0) << last.errors;
  std::vector<std::string> const columns{"frames/energy", "blobs/R", "blobs/U_kin", "blobs/U_pot"};
  auto const expected = datasets(unbroken / "vacuum.h5", columns);
  ASSERT_EQ(expected[0].size(), 150u);
  EXPECT_TRUE(expected == datasets(broken / "vacuum.h5", columns));
}

// The ranks of a killed program end a moment after it. The next one, started at once, waits for them.
TEST(KilledRun, OfAMeltOnTwoRanksIsResumedAtOnce) {
  ScratchDirectory const scratch;
  auto const melt = scratch / "melt";
  auto const command = [&] {
    std::vector<std::string> words{MESOBRIDGE_PROGRAM, "md", "star-melt", "--star", "3-1", "--ranks", "2"};
    words.insert(words.end(), {"--molecules", "64", "--rho", "0.1", "--equilibration-steps", "400",
                               "--sampling-steps", "6000", "--sample-every", "20", "--checkpoint-every",
                               "200", "--quiet", "-o", melt.string()});
    if (std::filesystem::exists(melt / "star-melt.restart"))
      words.emplace_back("--resume");
    return words;
  };
  auto const until_a_checkpoint = [&] {
    for (int k = 0; k < 4000 && !std::filesystem::exists(melt / "star-melt.restart"); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  ASSERT_TRUE(WIFSIGNALED(killed(until_a_checkpoint, SIGKILL, command())));
  auto const last = run_process(command());
  ASSERT_EQ(last.status, 0) << last.errors;
  Store const blobs(melt / "blobs.h5", Store::Mode::read), centres(melt / "centres.h5", Store::Mode::read);
  auto const steps = blobs.read_integers("frames/step");
  ASSERT_EQ(steps.size(), 300u);
  for (std::size_t k = 1; k < steps.size(); ++k)
    ASSERT_EQ(steps[k] - steps[k - 1], 20) << k;
  EXPECT_EQ(centres.read_integers("particles/trajectory/position/step"), steps);
}

// A chapter's runs are processes of their own, several at once. They end with the one that started them, and
// the next one goes on with each.
TEST(KilledRun, OfAChapterGoesOnWithAllItsRuns) {
  ScratchDirectory const scratch;
  auto const command = [](std::filesystem::path const& directory) {
    std::vector<std::string> words{MESOBRIDGE_PROGRAM, "workflow", "star-polymers", "--star", "4-1", "--rho"};
    words.insert(words.end(), {"0.3", "0.35", "0.4", "0.45", "--molecules", "125", "--sampling-steps",
                               "40000", "--vacuum-molecules", "60", "--vacuum-sampling-steps", "10000",
                               "--ranks", "2", "--json", "--quiet", "-o", directory.string()});
    return words;
  };
  auto const unbroken = scratch / "unbroken", broken = scratch / "broken";
  auto const whole = run_process(command(unbroken));
  ASSERT_EQ(whole.status, 0) << whole.errors;
  auto const begun = [&](char const* melt) {
    return std::filesystem::exists(broken / melt / "star-melt.restart");
  };
  auto const until_two_melts_are_under_way = [&] {
    for (int k = 0; k < 4000 && !(begun("melt-4-1-0.45") && begun("melt-4-1-0.4")); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  ASSERT_TRUE(WIFSIGNALED(killed(until_two_melts_are_under_way, SIGKILL, command(broken))));
  ASSERT_TRUE(begun("melt-4-1-0.45") && begun("melt-4-1-0.4"));
  for (char const* melt : {"melt-4-1-0.45", "melt-4-1-0.4"})
    EXPECT_FALSE(std::filesystem::exists(broken / melt / "summary.json"))
        << "one after the other, or too late";
  auto const last = run_process(command(broken));
  ASSERT_EQ(last.status, 0) << last.errors;
  std::vector<std::string> const columns{"frames/energy", "blobs/R", "blobs/U_kin", "blobs/U_pot"};
  for (std::string const melt : {"melt-4-1-0.3", "melt-4-1-0.35", "melt-4-1-0.4", "melt-4-1-0.45"}) {
    auto const expected = datasets(unbroken / melt / "blobs.h5", columns);
    ASSERT_GE(expected[0].size(), 400u) << melt;
    EXPECT_TRUE(expected == datasets(broken / melt / "blobs.h5", columns)) << melt;
  }
}

} // namespace
} // namespace mesobridge::workflows
