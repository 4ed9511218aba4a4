#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/coarse/cost_section.hpp"
#include "workflows/coarse/star_to_dpde.hpp"
#include "workflows/coarse/structure_comparison.hpp"
#include "workflows/json_file.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::workflows {
namespace {

using tests::program, tests::ScratchDirectory;

std::vector<std::string> small_chain(ScratchDirectory const& scratch) {
  return {"workflow",
          "star-to-dpde",
          "--star",
          "4-1",
          "--rho",
          "0.5",
          "--molecules",
          "125",
          "--sampling-steps",
          "20000",
          "--sample-every",
          "5",
          "--held-steps",
          "6000",
          "--configurations",
          "4",
          "--run-time",
          "40",
          "--cutoff",
          "3",
          "--run-dt",
          "0.05",
          "0.06",
          "--threads",
          "1",
          "-o",
          scratch.path().string(),
          "--json",
          "--quiet"};
}

// All stages of a small melt: what is written, that it is not made twice, and that a lost stage is made
// again.
TEST(StarToDpde, AMeltBecomesAFluidAndIsComparedWithIt) {
  ScratchDirectory const scratch;
  auto const result = program(small_chain(scratch));
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  for (char const* const key : {"diffusion", "P", "T_kin", "T_int"})
    for (char const* const of : {"_md", "_dpde", "_md_se", "_dpde_se"})
      EXPECT_TRUE(json.contains(std::string(key) + of)) << key << of;
  for (char const* const key : {"gamma_self", "gamma_self_se", "g_deviation", "g_deviation_se", "speed_up"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_GT(json["gamma_self"], 1);
  ASSERT_EQ(json["runs"].size(), 2u);
  EXPECT_EQ(json["runs"][1]["dt"], 0.06);
  EXPECT_GT(json["runs"][1]["seconds_per_molecule_and_time_dpde"], 0);
  EXPECT_NEAR(json["T_kin_dpde"].get<double>() / json["T_kin_md"].get<double>(), 1, 0.02);
  auto const html = read_text_file(scratch / "report.html");
  for (char const* const part : {"md held-blobs", "cg friction", "Correlation of the velocities",
                                 "Radial distribution", "Cost against error"})
    EXPECT_NE(html.find(part), std::string::npos) << part;

  auto const of_melt = std::filesystem::last_write_time(scratch / "melt/blobs.h5");
  std::filesystem::remove(scratch / "friction/friction.csv");
  auto words = small_chain(scratch); // and the model at its own state, as if it were another melt's
  words.insert(words.end(), {"--other-model", (scratch / "model/4-1-melt.toml").string()});
  auto const again = program(words);
  ASSERT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(std::filesystem::last_write_time(scratch / "melt/blobs.h5"), of_melt);
  auto const twice = Json::parse(again.output);
  for (char const* const key : {"diffusion_dpde", "P_dpde", "gamma_self", "g_deviation"})
    EXPECT_EQ(twice[key], json[key]) << key;
  ASSERT_EQ(twice["runs"].size(), 3u);
  for (char const* const key : {"P_dpde", "T_kin_dpde", "diffusion_dpde", "g_deviation"})
    EXPECT_EQ(twice["runs"][2][key], json[key]) << key;

  // The first run was interrupted: it goes on, with what a model of conduction says.
  auto journal = read_json(scratch / "stages.json");
  auto& done = journal["done"];
  std::size_t run = 0;
  while (done[run]["line"].get<std::string>().find("mesobridge run ") == std::string::npos)
    ++run;
  journal["begun"] = {done[run]["line"]};
  done.erase(done.begin() + std::ptrdiff_t(run), done.end());
  write_summary(scratch / "stages.json", journal);
  std::filesystem::remove(scratch / "run/summary.json");
  auto const resumed = program(words);
  ASSERT_EQ(resumed.status, 0) << resumed.errors;
  EXPECT_EQ(Json::parse(resumed.output)["P_dpde"], json["P_dpde"]);
  EXPECT_NE(read_text_file(scratch / "report.html").find("were interrupted"), std::string::npos);

  // What makes no exchange of energy or no model is refused.
  auto const blobs = (scratch / "melt/blobs.h5").string();
  int refused = 0;
  for (std::vector<std::string> const& words : std::vector<std::vector<std::string>>{
           {"cg", "exchange", blobs, "--cutoff", "100"},
           {"cg", "exchange", blobs, "--to", "1000"},
           {"cg", "exchange", blobs, "--bin-width", "0"},
           {"cg", "exchange", blobs, "--from", "-1"},
           {"cg", "exchange", blobs, "--friction", (scratch / "potential/potential.csv").string()},
           {"cg", "exchange", (scratch / "held/held.h5").string()},
           {"fit", "dpde", blobs, "--friction", (scratch / "exchange/conduction.csv").string()},
           {"fit", "dpde", blobs, "--potential", (scratch / "none.csv").string()}}) {
    auto const no = program(words);
    EXPECT_EQ(no.status, 2) << words[1] << " " << words.back() << no.errors;
    ++refused;
  }
  EXPECT_EQ(refused, 8);
}

TEST(StarToDpde, RefusesWhatMakesNoChainBeforeAnythingRuns) {
  struct Case {
    std::vector<std::string> words;
    std::string message;
  };
  std::vector<Case> const cases{{{"--molecules", "100"}, "must be a cube"},
                                {{"--configurations", "3"}, "at least 4"},
                                {{"--star", "6"}, "6"},
                                {{"--rho", "0.9"}, "density rho"},
                                {{"--held-steps", "0"}, "sampling steps"},
                                {{"--T", "-1"}, "temperature T"},
                                {{"--shock", "-1"}, "velocity of the piston"},
                                {{"--shock", "0.5", "--shock-across", "2"}, "molecules across"},
                                {{"--shock-along", "80"}, "needs --shock"},
                                {{"--run-dt", "0"}, "time step of the coarse run"},
                                {{"--run-dt", "0.1", "0.05", "0.05"}, "named once"},
                                {{"--run-time", "0.01"}, "at most its time"},
                                {{"--other-model", "none.toml"}, "none.toml"},
                                {{"--transfer"}, "several --rho"},
                                {{"--transfer", "--star", "6-3", "6-6"}, "several --rho"},
                                {{"--rho", "0.3", "0.3"}, "named once"},
                                {{"--rho", "0.3", "0.9"}, "density rho"},
                                {{"--star", "6-3", "6"}, "6"}};
  int refused = 0;
  for (auto const& [words, message] : cases) {
    ScratchDirectory const scratch;
    std::vector<std::string> call{"workflow", "star-to-dpde", "-o", (scratch / "out").string()};
    call.insert(call.end(), words.begin(), words.end());
    auto const result = program(call);
    EXPECT_EQ(result.status, 2) << words[0] << result.errors;
    EXPECT_NE(result.errors.find(message), std::string::npos) << result.errors;
    ++refused;
  }
  EXPECT_EQ(refused, 18);
}

// Two densities, and the model of the first at the second.
TEST(Long_StarToDpde, SeveralMeltsMakeOneReport) {
  ScratchDirectory const scratch;
  auto words = small_chain(scratch);
  words.erase(std::ranges::find(words, "--rho"), std::ranges::find(words, "--rho") + 2);
  words.insert(words.end(), {"--rho", "0.5", "0.4", "--transfer"});
  auto const result = program(words);
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const rows = Json::parse(result.output)["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["runs"].size(), 2u);
  ASSERT_EQ(rows[1]["runs"].size(), 3u);
  EXPECT_NE(rows[1]["runs"][2]["model"].get<std::string>().find("4-1-rho-0.5"), std::string::npos);
  EXPECT_LT(rows[1]["P_md"], rows[0]["P_md"]);
  auto const html = read_text_file(scratch / "report.html");
  for (char const* const part : {"4-1-rho-0.5/report.html", "model of 4-1-rho-0.5", "shear viscosity"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

// Chance falls with the root of the time and a bias stays.
TEST(Accuracy, SaysWhatAnErrorCosts) {
  Accuracy const molecules{.seconds = 100, .se = 0.02}, particles{.seconds = 10, .se = 0.02, .bias = 0.03};
  EXPECT_DOUBLE_EQ(molecules.error(100), 0.02);
  EXPECT_DOUBLE_EQ(molecules.error(400), 0.01);
  EXPECT_DOUBLE_EQ(*molecules.time_for(0.01), 400);
  EXPECT_NEAR(particles.error(1e12), 0.03, 1e-9);
  EXPECT_DOUBLE_EQ(*particles.time_for(0.05), 10 * 0.0004 / (0.0025 - 0.0009));
  EXPECT_FALSE(particles.time_for(0.03).has_value());
}

TEST(Stages, AreLinesForAShell) {
  EXPECT_EQ(line_of({.title = "", .words = {"run", "a b/scene.toml", "-o", "it's"}, .product = ""}),
            "mesobridge run 'a b/scene.toml' -o 'it'\\''s'");
}

/// Points that know nothing of each other, whose g is 1.
cg::BlobSeries ideal_points(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0, 8);
  cg::BlobSeries series{.molecules = 200, .atoms = 1, .mass = 1};
  Box box;
  box.edge = {8, 8, 8};
  for (int frame = 0; frame < 160; ++frame) {
    series.times.push_back(frame), series.boxes.push_back(box);
    for (int point = 0; point < 200; ++point)
      series.R.push_back({place(generator), place(generator), place(generator)});
  }
  return series;
}

// Two samples of one fluid differ by what their errors say, and by no more; a shift of 5 % is seen.
TEST(StructureComparison, KnowsWhatNoiseMakes) {
  auto const a = radial_estimate(ideal_points(1), 0.25);
  auto b = radial_estimate(ideal_points(2), 0.25);
  auto const same = structure_difference(a, b);
  EXPECT_EQ(same.bins, 16u);
  EXPECT_LT(same.share.mean, 2 * same.share.se);
  EXPECT_GT(same.share.mean, 0.4 * same.share.se);
  EXPECT_LT(same.largest_in_se, 5);
  for (auto& g : b.g)
    g.mean *= 1.05;
  EXPECT_GT(structure_difference(a, b).share.mean, 4 * same.share.se);
  EXPECT_NEAR(structure_difference(a, b).share.mean, 0.05, 0.02);
}

} // namespace
} // namespace mesobridge::workflows
