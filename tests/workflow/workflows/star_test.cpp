#include "chain_mapping.hpp"
#include "program.hpp"
#include "same_blobs.hpp"
#include "scratch_directory.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/text_file.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {

namespace {

using tests::program;
using tests::ScratchDirectory;

/// A dilute melt of a few stars, for so few steps that ranks have no time to part by chaos.
std::vector<std::string> short_melt(std::filesystem::path const& directory, std::string const& ranks,
                                    std::string const& steps) {
  return {"md",
          "star-melt",
          "--molecules",
          "27",
          "--rho",
          "0.02",
          "--equilibration-steps",
          "40",
          "--sampling-steps",
          steps,
          "--sample-every",
          "20",
          "--checkpoint-every",
          "20",
          "--ranks",
          ranks,
          "-o",
          directory.string(),
          "--json",
          "--quiet"};
}

TEST(StarCommands, BlobsDoNotDependOnTheNumberOfRanks) {
  // The thermostat's noise does, so both go on from the same checkpoint.
  ScratchDirectory const scratch;
  ASSERT_EQ(program(short_melt(scratch / "1", "1", "20")).status, 0);
  std::filesystem::copy(scratch / "1", scratch / "2");
  for (char const* ranks : {"1", "2"}) {
    auto words = short_melt(scratch / ranks, ranks, "40");
    words.emplace_back("--resume");
    auto const result = program(words);
    ASSERT_EQ(result.status, 0) << result.errors;
    auto const json = Json::parse(result.output);
    EXPECT_EQ(json["frames"], 2);
    EXPECT_LT(json["blob_energy_sum_relative_error_max"], 1e-9);
  }
  tests::expect_same_blobs(read_blobs(scratch / "1" / "blobs.h5"), read_blobs(scratch / "2" / "blobs.h5"),
                           2u * 27, 1e-8);
}

// What is told beside a preset counts; the rest is the preset's.
TEST(StarCommands, APresetFillsInWhatIsNotSaid) {
  ScratchDirectory const scratch;
  auto words = short_melt(scratch / "melt", "1", "40");
  words.insert(words.end(), {"--preset", "standard"});
  auto const result = program(words);
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  EXPECT_EQ(json["star"], "6-3");
  EXPECT_EQ(json["molecules"], 27);
  EXPECT_EQ(json["rho"], 0.02);
  EXPECT_NEAR(json["dt"].get<double>(), 0.002, 1e-15);
}

TEST(StarCommands, AShortRunIsToldThatItIsTooShort) {
  ScratchDirectory const scratch;
  ASSERT_EQ(program(short_melt(scratch / "melt", "1", "40")).status, 0);
  auto const result = program({"cg", "correlations", (scratch / "melt" / "blobs.h5").string(), "--json"});
  EXPECT_EQ(result.status, 2) << "two frames have no correlation time";
  EXPECT_NE(result.errors.find("at least 16"), std::string::npos) << result.errors;
}

TEST(StarCommands, AMeltHasADiffusion) {
  ScratchDirectory const scratch;
  ASSERT_EQ(program(short_melt(scratch / "melt", "1", "400")).status, 0);
  auto const result = program({"cg", "transport", (scratch / "melt" / "blobs.h5").string(), "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  EXPECT_GT(json["D_se"].get<double>(), 0);
  EXPECT_EQ(json["lag"].size(), json["displacement"].size());
  EXPECT_NEAR(json["velocity_correlation"][0].get<double>(), 1, 1e-12);
  EXPECT_GT(json["temperature"].get<double>(), 0.3);
  EXPECT_TRUE(std::filesystem::exists(scratch / "melt" / "transport.html"));
  auto const refused = program({"cg", "transport", (scratch / "melt" / "blobs.h5").string(), "--longest",
                                "1e9", "-o", scratch / "no"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("longest"), std::string::npos) << refused.errors;
}

TEST(StarCommands, IsolatedStarsHaveAnEntropy) {
  ScratchDirectory const scratch;
  auto const vacuum = program({"md",
                               "star-vacuum",
                               "--star",
                               "3-1",
                               "--T",
                               "0.9",
                               "1.1",
                               "--molecules",
                               "64",
                               "--dt",
                               "0.004",
                               "--equilibration-steps",
                               "1000",
                               "--sampling-steps",
                               "10000",
                               "--sample-every",
                               "500",
                               "--ranks",
                               "1",
                               "-o",
                               scratch.path().string(),
                               "--json",
                               "--quiet"});
  ASSERT_EQ(vacuum.status, 0) << vacuum.errors;
  EXPECT_EQ(Json::parse(vacuum.output)["frames"], 20);
  auto const result = program({"cg", "entropy", "--vacuum", (scratch / "vacuum.h5").string(), "--order", "2",
                               "-o", (scratch / "entropy").string(), "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  // Four beads: 9 quadratic momenta and 9 positions that are nearly quadratic.
  double const C = json["heat_capacity_vacuum"], se = json["heat_capacity_vacuum_se"];
  EXPECT_GT(C, 4.5);
  EXPECT_LT(C, 9.0);
  EXPECT_LT(se, 0.2 * C);
  double const other = json["heat_capacity_vacuum_kinetic"],
               other_se = json["heat_capacity_vacuum_kinetic_se"];
  EXPECT_LT(std::abs(C - other), 4 * std::hypot(se, other_se));
}

/// Two dumbbells that touch, one across the border of the box.
char const* const dumbbells = R"(ITEM: TIMESTEP
100
ITEM: NUMBER OF ATOMS
4
ITEM: BOX BOUNDS pp pp pp
0 10
0 10
0 10
ITEM: ATOMS id mol type x y z vx vy vz
3 2 1 1.0 2.0 5.0 0 0 0
1 1 1 9.5 1.0 5.0 1 0 0
4 2 1 2.2 2.0 5.0 0 2 0
2 1 1 0.9 1.0 5.0 -1 0 0
)";

std::string const dumbbell_mapping = tests::chain_mapping("dumbbell", 2, 20, 1.2);

TEST(StarCommands, AUsersTrajectoryBecomesBlobs) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "a.lammpstrj", dumbbells);
  write_text_file(scratch / "map.toml", dumbbell_mapping);
  auto const words = std::vector<std::string>{"cg",
                                              "blobs",
                                              (scratch / "a.lammpstrj").string(),
                                              "--mapping",
                                              (scratch / "map.toml").string(),
                                              "-o",
                                              scratch.path().string(),
                                              "--json"};
  auto const result = program(words);
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const data = read_blobs(scratch / "blobs.h5");
  ASSERT_EQ(data.R.size(), 2u);
  EXPECT_NEAR(data.R[0].x, 0.2, 1e-12) << "across the border";
  EXPECT_NEAR(data.U_kin[0], 1.0, 1e-12);
  EXPECT_NEAR(data.U_pot[0], 10 * 0.2 * 0.2, 1e-12);
  EXPECT_NEAR(data.P[1].y, 2.0, 1e-12);
  EXPECT_NEAR(data.U_kin[1], 1.0, 1e-12);
  // Atoms 2 and 3 are sqrt(0.01 + 1) apart, no others touch.
  double const s6 = std::pow(1.01, -3), wca = 4 * (s6 * s6 - s6) + 1;
  EXPECT_NEAR(data.Phi[0], wca / 2, 1e-9);
  EXPECT_NEAR(data.Phi[1], wca / 2, 1e-9);
}

// A restart writes its first step once more; another run's steps are not mixed with the first one's.
TEST(StarCommands, AStepThatStandsThereTwiceIsTakenOnce) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "a.lammpstrj", std::string(dumbbells) + dumbbells);
  write_text_file(scratch / "map.toml", dumbbell_mapping);
  auto const result = program({"cg", "blobs", (scratch / "a.lammpstrj").string(), "--mapping",
                               (scratch / "map.toml").string(), "-o", scratch.path().string(), "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(Json::parse(result.output)["frames"], 1);
  EXPECT_NE(result.errors.find("step 100 stands there twice"), std::string::npos) << result.errors;
  EXPECT_EQ(read_blobs(scratch / "blobs.h5").frames(), 1u);
}

TEST(StarCommands, AWorkflowOfOnesOwnIsReported) {
  ScratchDirectory const scratch;
  auto words = std::vector<std::string>{"workflow", "star-polymers"};
  words.insert(words.end(), {"--star", "4-1", "--rho", "0.5", "--molecules", "125", "--sampling-steps",
                             "40000", "--vacuum-molecules", "60", "--vacuum-sampling-steps", "10000",
                             "--ranks", "1", "-o", scratch.path().string(), "--json", "--quiet"});
  auto const result = program(words);
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output),
             summary = Json::parse(read_text_file(scratch / "summary.json"));
  ASSERT_EQ(summary["melts"].size(), 1u);
  EXPECT_EQ(summary["star"], "4-1");
  EXPECT_EQ(summary["rho"], 0.5);
  EXPECT_EQ(json["heat_capacity_melt"], summary["heat_capacity_melt"]);
  auto const html = read_text_file(scratch / "report.html");
  EXPECT_NE(html.find("4-1"), std::string::npos);
  EXPECT_NE(html.find("workflow star-polymers --star 4-1"), std::string::npos) << "its command";
  // What cannot be run is refused before anything is.
  words.insert(words.begin() + 6, "0.5");
  auto const twice = program(words);
  EXPECT_EQ(twice.status, 2);
  EXPECT_NE(twice.errors.find("must not be there twice"), std::string::npos) << twice.errors;
}

TEST(StarCommands, BenchSaysWhatBlobsCost) {
  ScratchDirectory const scratch;
  auto const result = program({"bench", "blobs", "--molecules", "27", "--rho", "0.05", "--repeats", "16",
                               "--ranks", "1", "-o", scratch.path().string(), "--json", "--quiet"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  EXPECT_EQ(json["atoms"], 27 * 19);
  EXPECT_EQ(json["sample_every"], 100);
  EXPECT_EQ(json["repeats"], 16);
  for (char const* key : {"md_atom_steps_per_s", "blobs_alone_percent_of_md", "blobs_alone_percent_of_md_se",
                          "cost_percent_of_md_se"})
    EXPECT_GT(json[key].get<double>(), 0) << key;
  EXPECT_TRUE(json["cost_percent_of_md"].is_number());
}

TEST(StarCommands, BadInputHasACodeAndOneClearMessage) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "a.lammpstrj", dumbbells);
  std::string three = dumbbell_mapping;
  three.replace(three.find("atoms = 2"), 9, "atoms = 3");
  three.replace(three.find("[1.0, 1.0]"), 10, "[1.0, 1.0, 1.0]");
  write_text_file(scratch / "three.toml", three);
  std::string unknown = dumbbell_mapping;
  write_text_file(scratch / "unknown.toml", unknown + "colour = \"red\"\n");
  write_text_file(scratch / "map.toml", dumbbell_mapping);
  std::string inside = dumbbells, between = dumbbells; // atoms of one molecule, of two on each other
  inside.replace(inside.find("2.2 2.0"), 7, "1.0 2.0");
  write_text_file(scratch / "inside.lammpstrj", inside);
  between.replace(between.find("1.0 2.0"), 7, "0.9 1.0");
  write_text_file(scratch / "between.lammpstrj", between);
  struct Case {
    std::vector<std::string> words;
    int status;
    std::string said;
  };
  auto const dump = (scratch / "a.lammpstrj").string();
  std::vector<Case> const cases{
      {{"md", "star-melt", "--star", "6x3"}, 2, "6-3"},
      {{"md", "star-melt", "--star", "13-3"}, 2, "1 ... 12"},
      {{"md", "star-melt", "--rho", "2"}, 2, "rho"},
      {{"md", "star-melt", "--molecules", "20", "--rho", "0.5"}, 2, "more molecules"},
      {{"md", "star-melt", "--dt", "0.02", "--T", "10", "--molecules", "100", "--ranks", "1"},
       3,
       "A shorter --dt"},
      {{"md", "star-vacuum", "--dt", "0.02", "--T", "10", "--molecules", "27", "--ranks", "1"},
       3,
       "A shorter --dt"},
      {{"md", "star-melt", "--star", "6-12", "--molecules", "70"}, 2, "half the box"},
      {{"cg", "blobs", (scratch / "inside.lammpstrj").string(), "--mapping", (scratch / "map.toml").string()},
       2,
       "on top of others"},
      {{"cg", "blobs", (scratch / "between.lammpstrj").string(), "--mapping",
        (scratch / "map.toml").string()},
       2,
       "on top of others"},
      {{"md", "star-vacuum", "--T", "-1"}, 2, "must be > 0"},
      {{"cg", "blobs", dump, "--mapping", (scratch / "three.toml").string()}, 2, "1 atoms are left out"},
      {{"cg", "blobs", dump, "--mapping", (scratch / "unknown.toml").string()}, 2, "colour"},
      {{"cg", "blobs", (scratch / "none").string(), "--mapping", (scratch / "three.toml").string()},
       2,
       "none"},
      {{"cg", "correlations", (scratch / "none.h5").string()}, 2, "none.h5"},
      {{"cg", "entropy"}, 2, "--melt"}};
  for (auto const& [words, status, said] : cases) {
    auto all = words;
    all.insert(all.end(), {"-o", (scratch / "out").string()});
    auto const result = program(all);
    EXPECT_EQ(result.status, status) << words[1] << ": " << result.errors;
    EXPECT_NE(result.errors.find(said), std::string::npos) << result.errors;
    auto const first = result.errors.find("mesobridge: ");
    EXPECT_EQ(result.errors.find("mesobridge: ", first + 1), std::string::npos) << "one message";
  }
  EXPECT_EQ(cases.size(), 15u);
}

} // namespace

} // namespace mesobridge::workflows
