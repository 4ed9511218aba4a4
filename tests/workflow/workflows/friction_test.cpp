#include "long_inputs.hpp"
#include "program.hpp"
#include "refusals.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/star/held_file.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::program;
using tests::ScratchDirectory;

/// A melt of 125 3-1 stars, held in some configurations.
std::vector<std::string> held_melt(std::filesystem::path const& directory,
                                   std::string const& configurations) {
  return {"md",
          "held-blobs",
          "--star",
          "3-1",
          "--molecules",
          "125",
          "--rho",
          "0.3",
          "--equilibration-steps",
          "1000",
          "--sampling-steps",
          "2500",
          "--free-steps",
          "500",
          "--checkpoint-every",
          "500",
          "--configurations",
          configurations,
          "--ranks",
          "1",
          "-o",
          directory.string(),
          "--json",
          "--quiet"};
}

TEST(FrictionCommands, LeadFromAMeltToATableThatASceneTakes) {
  ScratchDirectory const scratch;
  auto const melt = program(held_melt(scratch / "held", "4"));
  ASSERT_EQ(melt.status, 0) << melt.errors;
  auto const run = Json::parse(melt.output);
  EXPECT_EQ(run["configurations"], 4);
  EXPECT_EQ(run["frames"], 2000);
  EXPECT_LT(run["blob_energy_sum_relative_error_max"], 1e-9);
  EXPECT_NEAR(run["T_kin"].get<double>(), 1, 0.05);
  auto const found = program({"cg", "friction", (scratch / "held" / "held.h5").string(), "--json"});
  ASSERT_EQ(found.status, 0) << found.errors;
  auto const json = Json::parse(found.output);
  double const self = json["gamma_self"], se = json["gamma_self_se"];
  EXPECT_GT(self, 5 * se);
  EXPECT_LT(std::abs(json["table_sum_deviation"].get<double>()), 0.01);
  EXPECT_EQ(json["r"].size(), json["gamma_perp_se"].size());
  for (double const gamma : json["table"]["gamma_par"])
    EXPECT_GE(gamma, 0);
  EXPECT_TRUE(std::filesystem::exists(scratch / "held" / "friction.html"));
  auto const csv = scratch / "held" / "friction.csv";
  EXPECT_TRUE(read_text_file(csv).starts_with("r,gamma_par,gamma_perp\n"));
  write_text_file(
      scratch / "star.toml",
      "title = \"stars\"\nunits = \"lj\"\n[method]\nname = \"dpd\"\n[fluid]\nrho = 0.3\nT = 1\n[particles]\n"
      "N = 1000\nmass = 4\n[potential]\nname = \"soft\"\na = 5\ncutoff = 3\n[friction]\nfile = \"" +
          csv.string() + "\"\n[scheme]\ndt = 0.01\n[run]\nsteps = 1000\nsample_every = 10\n");
  auto const scene = program({"check", (scratch / "star.toml").string()});
  EXPECT_EQ(scene.status, 0) << scene.errors;
}

TEST(FrictionCommands, ARunGoesOnWithMoreConfigurations) {
  ScratchDirectory const scratch;
  ASSERT_EQ(program(held_melt(scratch / "a", "1")).status, 0);
  auto more = held_melt(scratch / "a", "2");
  more.emplace_back("--resume");
  auto const result = program(more);
  ASSERT_EQ(result.status, 0) << result.errors;
  ASSERT_EQ(program(held_melt(scratch / "b", "2")).status, 0);
  auto const a = read_held(scratch / "a" / "held.h5"), b = read_held(scratch / "b" / "held.h5");
  EXPECT_EQ(a.whole_configurations(), 2u);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_TRUE(a.R == b.R && a.F == b.F && a.U_kin == b.U_kin && a.Phi == b.Phi);
}

TEST(FrictionCommands, ForcesDoNotDependOnTheNumberOfRanks) {
  // The thermostat's noise does, so there is next to none; and few steps, so that chaos has no time.
  ScratchDirectory const scratch;
  for (std::string const ranks : {"1", "2"}) {
    auto const result = program({"md",
                                 "held-blobs",
                                 "--star",
                                 "3-1",
                                 "--molecules",
                                 "64",
                                 "--rho",
                                 "0.1",
                                 "--dt",
                                 "0.001",
                                 "--squeeze-steps",
                                 "200",
                                 "--friction",
                                 "1e-24",
                                 "--equilibration-steps",
                                 "40",
                                 "--sampling-steps",
                                 "40",
                                 "--sample-every",
                                 "20",
                                 "--free-steps",
                                 "20",
                                 "--checkpoint-every",
                                 "20",
                                 "--configurations",
                                 "2",
                                 "--ranks",
                                 ranks,
                                 "-o",
                                 (scratch / ranks).string(),
                                 "--quiet"});
    ASSERT_EQ(result.status, 0) << result.errors;
  }
  auto const one = read_held(scratch / "1" / "held.h5"), two = read_held(scratch / "2" / "held.h5");
  ASSERT_EQ(one.F.size(), 4u * 64);
  ASSERT_EQ(two.F.size(), one.F.size());
  int pushed = 0;
  for (std::size_t k = 0; k < one.F.size(); ++k) {
    EXPECT_LT(norm(one.F[k] - two.F[k]), 1e-5 * (1 + norm(one.F[k])));
    EXPECT_NEAR(one.U_kin[k], two.U_kin[k], 1e-5);
    pushed += norm(one.F[k]) > 0.1;
  }
  EXPECT_GT(pushed, 0);
}

TEST(FrictionCommands, BadInputIsRefusedByName) {
  ScratchDirectory const scratch;
  auto const held = (scratch / "held.h5").string(), few = (scratch / "few.h5").string(),
             brief = (scratch / "brief.h5").string(), melt = (scratch / "melt.h5").string();
  tests::write_many_held(held, 60, 4, 400);
  tests::write_many_held(few, 60, 3, 100);
  tests::write_many_held(brief, 60, 4, 70);
  tests::write_many_blobs(melt, "melt", 60, 20);
  std::vector<tests::Refusal> const cases{
      {{"cg", "friction", melt}, 2, "`md held-blobs` makes such files"},
      {{"cg", "friction", (scratch / "none.h5").string()}, 2, "none.h5"},
      {{"cg", "transport", held}, 2, "`cg friction` reads it"},
      {{"cg", "correlations", held}, 2, "`cg friction` reads it"},
      {{"cg", "friction", few}, 2, "whole configurations = 3"},
      {{"cg", "friction", brief}, 2, "held"},
      {{"cg", "friction", held, "--plateau", "10"}, 2, "held"},
      {{"cg", "friction", held, "--bin-width", "0"}, 2, "width of the bins"},
      {{"cg", "friction", held, "--cutoff", "100"}, 2, "cut-off"},
      {{"cg", "friction", held, "--cutoff", "-1"}, 2, "cut-off"},
      {{"cg", "friction", held, "--knots", "nan"}, 2, "knots"},
      {{"md", "held-blobs", "--configurations", "0"}, 2, "configurations"},
      {{"md", "held-blobs", "--free-steps", "0"}, 2, "steps between configurations"},
      {{"md", "held-blobs", "--rho", "2"}, 2, "density"}};
  EXPECT_EQ(tests::expect_refusals(cases), 14);
  EXPECT_FALSE(std::filesystem::exists(scratch / "friction.csv"));
}

} // namespace
} // namespace mesobridge::workflows
