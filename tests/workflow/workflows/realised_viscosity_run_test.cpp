#include "scratch_directory.hpp"
#include "sdpd_scene.hpp"
#include "workflows/process.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

// eta_means = "realised" as its users run it.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

/// A viscous gas, whose waves are damped within few steps.
std::string scene_text(std::string const& more = "") {
  auto scene = tests::ideal_gas_scene("equilibrate = 32\nsteps = 400\n");
  scene.particles = "density = \"plain\"\nstart = \"melted\"\n", scene.scheme = "dt = 0.1\n";
  auto text = scene.text();
  auto const eta = std::string("eta = \"2e-3 Pa*s\"\n");
  return text.replace(text.find(eta), eta.size(), "eta = \"8e-3 Pa*s\"\neta_means = \"realised\"\n" + more);
}

ProcessResult mesobridge(std::vector<std::string> words) {
  words.insert(words.begin(), MESOBRIDGE_PROGRAM);
  return run_process(words);
}

TEST(RunOfRealisedViscosity, FindsTheFrictionOnceAndStatesWhatItHas) {
  ScratchDirectory const scratch;
  auto const scene = (scratch / "scene.toml").string();
  write_text_file(scene, scene_text());
  auto const checked = mesobridge({"check", scene, "--threads", "1"});
  EXPECT_NE(checked.output.find("eta_means = \"realised\": trials of 1024 particles"), std::string::npos)
      << checked.output << checked.errors;
  EXPECT_NE(checked.output.find("for trials of the viscosity"), std::string::npos);

  auto const first = mesobridge({"run", scene, "-o", (scratch / "first").string(), "--threads", "1"});
  ASSERT_EQ(first.status, 0) << first.errors;
  EXPECT_NE(first.output.find("(asked: 0.008 Pa s, of the pairs: "), std::string::npos) << first.output;
  auto const summary = Json::parse(read_text_file(scratch / "first" / "summary.json"));
  EXPECT_EQ(summary["eta_asked_Pa_s"], 8e-3);
  double const realised = summary["eta_realised_Pa_s"], se = summary["eta_realised_Pa_s_se"];
  EXPECT_NEAR(realised / 8e-3, 1, 0.025);
  EXPECT_GT(se, 0);
  EXPECT_LT(se, 0.03 * realised);
  EXPECT_GE(summary["viscosity_trials"]["trials"].size(), 2u);
  double const pairs = summary["eta_pairs_Pa_s"];
  EXPECT_NE(pairs, 8e-3);
  EXPECT_NE(read_text_file(scratch / "first" / "report.html").find("shear viscosity, by trials"),
            std::string::npos);

  // What was found serves a longer run in the same folder, and the resolved scene anywhere, on more threads.
  auto const resolved = read_text_file(scratch / "first" / "scene.toml");
  EXPECT_NE(resolved.find(fmt::format("eta_pairs = \"{} Pa*s\"", pairs)), std::string::npos) << resolved;
  auto const longer = mesobridge(
      {"run", scene, "-o", (scratch / "first").string(), "--resume", "--quiet", "--set", "run.steps=600"});
  EXPECT_EQ(longer.status, 0) << longer.errors;
  EXPECT_EQ(Json::parse(read_text_file(scratch / "first" / "summary.json"))["eta_realised_Pa_s"], realised);
  auto const again = mesobridge({"run", (scratch / "first" / "scene.toml").string(), "-o",
                                 (scratch / "again").string(), "--threads", "2", "--quiet"});
  ASSERT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(Json::parse(read_text_file(scratch / "again" / "summary.json"))["eta_pairs_Pa_s"], pairs);
  EXPECT_FALSE(std::filesystem::exists(scratch / "again" / "viscosity.json"));
}

TEST(RunOfRealisedViscosity, IsRefusedWhereNoFrictionHasIt) {
  ScratchDirectory const scratch;
  auto const scene = (scratch / "scene.toml").string();
  write_text_file(scene, scene_text());
  struct Case {
    std::vector<std::string> set;
    std::vector<std::string> says;
  };
  int refused = 0;
  for (auto const& [set, says] :
       {Case{{"particles.K=10", "transport.eta=1e-5 Pa*s"}, {"transport.eta = 1e-05", "realised", "motion"}},
        {{"method.name=sph"}, {"transport.eta_means", "without noise"}},
        {{"transport.eta_means=pair", "transport.eta_pairs=1e-3 Pa*s"}, {"transport.eta_pairs", "realised"}},
        {{"transport.eta_pairs=1e-3 Pa*s", "transport.zeta=2e-3 Pa*s"}, {"transport.zeta", "0.00166667"}}}) {
    std::vector<std::string> words{"check", scene};
    for (auto const& one : set)
      words.insert(words.end(), {"--set", one});
    auto const result = mesobridge(words);
    EXPECT_EQ(result.status, 2) << set[0];
    for (auto const& part : says)
      EXPECT_NE(result.errors.find(part), std::string::npos) << part << "\n" << result.errors;
    ++refused;
  }
  EXPECT_EQ(refused, 4);
}

} // namespace
} // namespace mesobridge::workflows
