#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/process.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <numeric>

// `mesobridge run` and `bench engine` with DPD and DPDE, as their users run them.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

ProcessResult run(std::string const& scene, std::filesystem::path const& directory,
                  std::vector<std::string> const& more = {}) {
  std::vector<std::string> words{MESOBRIDGE_PROGRAM,
                                 "run",
                                 MESOBRIDGE_SOURCE_DIR "/workflows/scenes/" + scene + ".toml",
                                 "-o",
                                 directory.string(),
                                 "--quiet",
                                 "--json"};
  for (char const* set :
       {"particles.N=512", "run.equilibrate=64", "run.steps=320", "run.sample_every=5",
        "run.trajectory_every=100", "run.checkpoint_every=150", "profile.every=5", "profile.bins=4"})
    words.insert(words.end(), {"--set", set});
  words.insert(words.end(), more.begin(), more.end());
  return run_process(words);
}

std::vector<double> thermodynamics(std::filesystem::path const& directory) {
  return Store(directory / "run.h5", Store::Mode::read).read_doubles("thermodynamics");
}

class PairRun : public ::testing::TestWithParam<char const*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, PairRun, ::testing::Values("dpd-fluid", "dpde-fluid"),
                         [](auto const& info) { return info.index == 0 ? "dpd" : "dpde"; });

TEST_P(PairRun, WritesItsFilesAndGoesOnFromACheckpoint) {
  bool const energies = std::string(GetParam()) == "dpde-fluid";
  ScratchDirectory const scratch;
  auto const first = run(GetParam(), scratch / "a", {"--threads", "1"});
  ASSERT_EQ(first.status, 0) << first.errors;
  auto const json = Json::parse(first.output);
  EXPECT_NEAR(json["T_kin"].get<double>(), 1, 0.05);
  EXPECT_NEAR(json["P"].get<double>(), 23.6, 1);
  EXPECT_GT(json["P_se"].get<double>(), 0);
  EXPECT_TRUE(json.contains("potential_energy_per_particle_se"));
  EXPECT_EQ(json.contains("T_int"), energies);
  EXPECT_EQ(json.contains("energy_drift_per_reduced_time"), energies);
  EXPECT_FALSE(json.contains("K"));
  EXPECT_EQ(thermodynamics(scratch / "a").size(), 65u * (energies ? 12u : 10u));
  EXPECT_NE(read_text_file(scratch / "a" / "report.html").find(energies ? "DPDE particles" : "DPD particles"),
            std::string::npos);
  auto const P = Store(scratch / "a" / "run.h5", Store::Mode::read).read_doubles("profile/P");
  ASSERT_EQ(P.size(), 65u * 4u);
  double const mean = std::accumulate(P.begin(), P.end(), 0.0) / static_cast<double>(P.size());
  EXPECT_NEAR(mean, json["P"].get<double>(), 3 * json["P_se"].get<double>() + 0.02);
  // From the checkpoint after 160 of the 320 steps to the same end, on two threads.
  auto const half = run(GetParam(), scratch / "b",
                        {"--threads", "1", "--set", "run.steps=160", "--set", "run.instant_every=8"});
  ASSERT_EQ(half.status, 0) << half.errors;
  auto const resumed = run(GetParam(), scratch / "b", {"--threads", "2", "--resume"});
  ASSERT_EQ(resumed.status, 0) << resumed.errors;
  EXPECT_EQ(thermodynamics(scratch / "a"), thermodynamics(scratch / "b"));
  EXPECT_EQ(read_text_file(scratch / "a" / "summary.json"), read_text_file(scratch / "b" / "summary.json"));
}

TEST(BenchEngine, TimesDpdAndDpde) {
  for (char const* method : {"dpd", "dpde"}) {
    auto const result = run_process({MESOBRIDGE_PROGRAM, "bench", "engine", "--method", method,
                                     "--neighbours", "20", "--side", "8", "--steps", "2", "--json"});
    ASSERT_EQ(result.status, 0) << result.errors;
    auto const json = Json::parse(result.output);
    EXPECT_EQ(json["method"], method);
    EXPECT_NEAR(json["neighbours"].get<double>(), 20, 3);
  }
}

TEST(BenchEngine, TimesWallsOpenFacesAndVacuumBesideThePeriodicBox) {
  auto const result = tests::program({"bench", "engine", "--faces", "--side", "8", "--along", "16", "--steps",
                                      "4", "--repeats", "3", "--threads", "1", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const rows = Json::parse(result.output)["faces"];
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0]["ratio"], 1.0);
  int timed = 0;
  for (auto const& row : rows) {
    EXPECT_GT(row["us_per_particle_step"].get<double>(), 0) << row;
    EXPECT_GT(row["ratio"].get<double>(), 0.1) << row;
    ASSERT_LT(row["list_renewals_per_step"].get<double>(), 1) << row;
    EXPECT_GT(row["without_renewals"]["ratio"].get<double>(), 0.1) << row;
    ++timed;
  }
  EXPECT_EQ(timed, 4);
  // Who stands at a face has fewer neighbours; the box's emptiness changes nothing.
  EXPECT_LT(rows[2]["neighbours"].get<double>(), rows[0]["neighbours"].get<double>());
  EXPECT_NEAR(rows[2]["neighbours"].get<double>() / rows[3]["neighbours"].get<double>(), 1, 1e-3);
}

TEST(BenchEngine, TimesStepsInsideLammpsBesideTheBuiltInOnes) {
  for (char const* ranks : {"1", "2"}) {
    auto const result =
        tests::program({"bench", "engine", "--on-ranks", "--ranks", ranks, "--method", "dpde", "--neighbours",
                        "20", "--side", "12", "--steps", "4", "--repeats", "3", "--json"});
    ASSERT_EQ(result.status, 0) << result.errors;
    auto const json = Json::parse(result.output);
    EXPECT_EQ(std::to_string(json["ranks"].get<int>()), ranks);
    auto const rows = json["engines"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["engine"], "built-in");
    EXPECT_EQ(rows[0]["ratio"], 1.0);
    EXPECT_EQ(rows[1]["engine"], "lammps");
    for (auto const& row : rows)
      EXPECT_GT(row["us_per_particle_step"].get<double>(), 0) << row;
    EXPECT_GT(rows[1]["ratio_se"].get<double>(), 0);
  }
  auto const refused =
      tests::program({"bench", "engine", "--on-ranks", "--side", "12", "--kappa", "0.1", "--ranks", "2"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("conduction"), std::string::npos) << refused.errors;
}

TEST(BenchEngine, TimesADetonationBesideTheIdealGas) {
  auto const result = tests::program({"bench", "engine", "--detonation", "--side", "6", "--along", "48",
                                      "--steps", "2", "--repeats", "3", "--threads", "1", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const rows = Json::parse(result.output)["fluids"];
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0]["ratio"], 1.0);
  EXPECT_EQ(rows[0]["mixtures"], 0.0);
  EXPECT_GT(rows[1]["neighbours"].get<double>(), rows[0]["neighbours"].get<double>() + 5);
  EXPECT_GT(rows[2]["mixtures"].get<double>(), 0.99);
  double const zone = rows[3]["mixtures"]; // behind unburnt particles, before the burnt ones of the beginning
  EXPECT_GT(zone, 0.05);
  EXPECT_LT(zone, 0.7);
  for (auto const& row : rows)
    EXPECT_GT(row["us_per_particle_step"].get<double>(), 0) << row;
  auto const other = tests::program({"bench", "engine", "--detonation", "--method", "dpd"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.errors.find("--method"), std::string::npos) << other.errors;
}

} // namespace
} // namespace mesobridge::workflows
