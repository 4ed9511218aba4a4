#include "program.hpp"
#include "scratch_directory.hpp"
#include "sdpd_scene.hpp"
#include "workflows/command.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <chrono>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>

// Cost against accuracy as its users study it: trade-off, automatic time steps, reproductions.

namespace mesobridge::workflows {
namespace {

using tests::program;
using tests::ScratchDirectory;

std::vector<std::string> study(ScratchDirectory const& scratch, std::vector<std::string> const& more = {}) {
  std::vector<std::string> words{"trade-off",
                                 MESOBRIDGE_SOURCE_DIR "/workflows/scenes/ideal-gas.toml",
                                 "--schemes",
                                 "ssa,ems",
                                 "--integrators",
                                 "verlet",
                                 "--dt",
                                 "0.1,0.2,0.3,0.9",
                                 "--time",
                                 "110",
                                 "--particles",
                                 "216",
                                 "--drift",
                                 "1e-4/ps",
                                 "-o",
                                 (scratch / "study").string(),
                                 "--quiet",
                                 "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<std::string> words_of(std::string const& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(TradeOffCommand, MeasuresRecommendsAndGoesOnWhereItStopped) {
  ScratchDirectory const scratch;
  auto const first = program(study(scratch, {"--no-limit"}));
  ASSERT_EQ(first.status, 0) << first.errors;
  auto const json = Json::parse(first.output);
  ASSERT_EQ(json["configurations"].size(), 2u);
  int finished = 0, failed = 0;
  for (auto const& of : json["configurations"])
    for (auto const& trial : of["trials"]) {
      if (trial.contains("failure")) {
        ++failed; // far beyond Verlet's limit
        EXPECT_EQ(trial["dt_reduced"], 0.9);
        continue;
      }
      ++finished;
      for (char const* key : {"us_per_particle_ps", "energy_drift_per_ps", "energy_drift_per_ps_se",
                              "bias_T_kin_se", "bias_P", "eps_distribution_error", "rejected_metropolis"})
        EXPECT_TRUE(trial.contains(key)) << key;
    }
  EXPECT_EQ(finished, 6);
  EXPECT_EQ(failed, 2);
  ASSERT_EQ(json["recommended"].size(), 1u);
  EXPECT_GT(json["recommended"][0]["dt_reduced"], 0.05);
  EXPECT_LT(json["recommended"][0]["dt_reduced"], 0.8);
  // What is printed to apply it does so.
  auto words = words_of(json["recommended"][0]["set"].get<std::string>());
  EXPECT_EQ(words.size(), 10u) << "scheme, splitting, conservative, dt and K";
  words.insert(words.begin(), {"check", MESOBRIDGE_SOURCE_DIR "/workflows/scenes/ideal-gas.toml"});
  auto const checked = program(words);
  ASSERT_EQ(checked.status, 0) << checked.errors;
  EXPECT_NE(
      checked.output.find(fmt::format("name = \"{}\"", json["recommended"][0]["scheme"].get<std::string>())),
      std::string::npos)
      << checked.output;
  EXPECT_NE(read_text_file(scratch / "study" / "report.html").find("<svg"), std::string::npos);
  // What is stored is not run again; a trial that is missing is, and comes out the same but for its times.
  auto const one = scratch / "study" / "trials" / "K10-ems-lie-trotter-verlet-dt0.2.json";
  auto before = Json::parse(read_text_file(one));
  std::filesystem::remove(one);
  auto const again = program(study(scratch, {"--no-limit", "--threads", "1"}));
  ASSERT_EQ(again.status, 0) << again.errors;
  auto after = Json::parse(read_text_file(one));
  for (auto* of : {&before, &after})
    of->erase("us_per_particle_step");
  EXPECT_EQ(before, after);
  auto const untouched = Json::parse(again.output)["configurations"][0];
  EXPECT_EQ(untouched, json["configurations"][0]); // with its times: it was read
}

class SoftTradeOff : public ::testing::TestWithParam<char const*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, SoftTradeOff, ::testing::Values("dpd-fluid", "dpde-fluid"),
                         [](auto const& info) { return info.index == 0 ? "dpd" : "dpde"; });

TEST_P(SoftTradeOff, RecommendsATimeStepThatKeepsTheTemperature) {
  bool const energies = std::string(GetParam()) == "dpde-fluid";
  std::string const scene = MESOBRIDGE_SOURCE_DIR "/workflows/scenes/" + std::string(GetParam()) + ".toml";
  ScratchDirectory const scratch;
  auto const study = program({"trade-off", scene, "--schemes", "ssa", "--integrators", "verlet", "--dt",
                              "0.01,0.02,0.04,0.06", "--time", "150", "--particles", "216", "--no-limit",
                              "--bias", "1%", "-o", (scratch / "study").string(), "--quiet", "--json"});
  ASSERT_EQ(study.status, 0) << study.errors;
  auto const json = Json::parse(study.output);
  ASSERT_EQ(json["configurations"].size(), 1u);
  EXPECT_FALSE(json["configurations"][0].contains("K"));
  int finished = 0;
  double se_of_study = 0;
  for (auto const& trial : json["configurations"][0]["trials"]) {
    double const bias_se = trial["bias_T_kin_se"];
    EXPECT_GT(bias_se, 0);
    EXPECT_EQ(trial.contains("energy_drift_per_time"), energies);
    EXPECT_EQ(trial.contains("bias_T_int"), energies);
    EXPECT_EQ(trial.contains("eps_distribution_error"), energies);
    ++finished;
  }
  EXPECT_EQ(finished, 4);
  ASSERT_EQ(json["recommended"].size(), 1u);
  double const dt = json["recommended"][0]["dt_reduced"];
  EXPECT_GT(dt, 0.005);
  EXPECT_LE(dt, 0.06);
  for (auto const& trial :
       json["configurations"][0]["trials"]) // longer steps heat the fluid: trends are errors
    if (trial["dt_reduced"].get<double>() <= 0.045)
      se_of_study = std::max(se_of_study, trial["bias_T_kin_se"].get<double>());
  EXPECT_GT(se_of_study, 0);
  // Another run at that step, of a fluid whose temperature is known.
  auto const run = program({"run", scene, "-o", (scratch / "run").string(), "--quiet", "--json", "--seed",
                            "7", "--set", fmt::format("scheme.dt={}", dt), "--set", "particles.N=729",
                            "--set", fmt::format("run.steps={}", static_cast<int>(60 / dt))});
  ASSERT_EQ(run.status, 0) << run.errors;
  auto const found = Json::parse(run.output);
  double const T = found["T_kin"], se = found["T_kin_se"];
  EXPECT_LT(se, 0.01);
  EXPECT_LT(se_of_study, 0.007) << "the study knows the bias well enough to tell 1 % from 3 %";
  EXPECT_LT(std::abs(T - 1), 0.01 + 3 * std::hypot(se, se_of_study));
  EXPECT_NE(read_text_file(scratch / "study" / "report.html").find("<svg"), std::string::npos);
}

TEST(TradeOffCommand, RefusesWhatItCannotStudy) {
  ScratchDirectory const scratch;
  struct Case {
    std::vector<std::string> more;
    char const* message;
    std::string scene = "ideal-gas";
  };
  int ran = 0;
  for (auto const& [more, message, scene] :
       {Case{{"--schemes", "sss"}, "ems"}, Case{{"--dt", "-1"}, "--dt"},
        Case{{"--drift", "1e-6"}, "per unit of time"}, Case{{"--integrators", "euler"}, "mclachlan"},
        Case{{"--bias", "2"}, "0.5%"}, Case{{"--drift", "1e-6"}, "keeps no energy", "dpd-fluid"},
        Case{{"--schemes", "ems"}, "no internal energies", "dpd-fluid"},
        Case{{"--K", "10"}, "--K", "dpde-fluid"}}) {
    std::vector<std::string> words{"trade-off", MESOBRIDGE_SOURCE_DIR "/workflows/scenes/" + scene + ".toml",
                                   "-o", (scratch / "x").string()};
    words.insert(words.end(), more.begin(), more.end());
    auto const result = program(words);
    EXPECT_EQ(result.status, 2) << result.errors;
    EXPECT_NE(result.errors.find(message), std::string::npos) << result.errors;
    ++ran;
  }
  EXPECT_EQ(ran, 8);
}

std::string auto_scene() {
  auto scene = tests::ideal_gas_scene("equilibrate = 64\nsteps = 640\n");
  scene.K = 10, scene.scheme = "dt = \"auto\"\ndrift = \"1e-4/ps\"\n";
  return scene.text();
}

TEST(AutomaticTimeStep, MeetsATolerableBiasOfDpd) {
  ScratchDirectory const scratch;
  auto run = [&](std::string const& tolerance) {
    return program({"run", MESOBRIDGE_SOURCE_DIR "/workflows/scenes/dpd-fluid.toml", "-o",
                    (scratch / "a").string(), "--quiet", "--json", "--set", "scheme.dt=auto", "--set",
                    tolerance, "--set", "particles.N=729", "--set", "run.steps=1600"});
  };
  auto const result = run("scheme.bias=1 %");
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  double const dt = json["dt_reduced"], T = json["T_kin"], se = json["T_kin_se"];
  EXPECT_GT(dt, 0.01);
  EXPECT_LE(dt, 0.06);
  EXPECT_LT(std::abs(T - 1), 0.01 + 3 * se);
  auto const resolved = read_text_file(scratch / "a" / "scene.toml");
  EXPECT_NE(resolved.find("dt_chosen_for = \"bias 1 %\""), std::string::npos) << resolved;
  auto const drift = run("scheme.drift=\"1e-4\"");
  EXPECT_EQ(drift.status, 2);
  EXPECT_NE(drift.errors.find("give a bias"), std::string::npos) << drift.errors;
}

TEST(AutomaticTimeStep, IsFoundStoredAndKeptOnResume) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "s.toml", auto_scene());
  auto run = [&](std::string const& name, std::vector<std::string> const& more) {
    std::vector<std::string> words{"run", (scratch / "s.toml").string(), "-o", (scratch / name).string()};
    words.insert(words.end(), more.begin(), more.end());
    return program(words);
  };
  auto const first = run("a", {"--set", "run.checkpoint_every=300"});
  ASSERT_EQ(first.status, 0) << first.errors;
  EXPECT_NE(first.errors.find("chosen for drift 1e-4/ps"), std::string::npos) << first.errors;
  auto const resolved = read_text_file(scratch / "a" / "scene.toml");
  EXPECT_NE(resolved.find("dt_chosen_for = \"drift 1e-4/ps\""), std::string::npos) << resolved;
  auto const summary = Json::parse(read_text_file(scratch / "a" / "summary.json"));
  auto const kept = summary["tolerances"]["drift"]; // per second
  EXPECT_NEAR(kept["wanted_per_s"].get<double>(), 1e8, 1e-6);
  double const rate = summary["energy_drift_per_s"], se = summary["energy_drift_per_s_se"];
  EXPECT_DOUBLE_EQ(kept["found_per_s"].get<double>(), std::abs(rate));
  EXPECT_EQ(kept["fulfilled"].get<bool>(), std::abs(rate) - 2 * se <= 1e8);
  EXPECT_EQ(resolved.find("auto\"\ndrift"), std::string::npos) << resolved;
  auto rows = [&](std::string const& name) {
    return Store(scratch / name / "run.h5", Store::Mode::read).read_doubles("thermodynamics");
  };
  auto const unbroken = rows("a");
  EXPECT_EQ(unbroken.size(), 65u * 12u);
  // From the last checkpoint, step 600 of 640, without another study.
  std::filesystem::remove_all(scratch / "a" / "dt-auto");
  auto const resumed = run("a", {"--set", "run.checkpoint_every=300", "--resume"});
  ASSERT_EQ(resumed.status, 0) << resumed.errors;
  EXPECT_FALSE(std::filesystem::exists(scratch / "a" / "dt-auto"));
  EXPECT_TRUE(unbroken == rows("a"));
  // The resolved scene runs to the same bits.
  auto const other =
      program({"run", (scratch / "a" / "scene.toml").string(), "-o", (scratch / "b").string()});
  ASSERT_EQ(other.status, 0) << other.errors;
  EXPECT_TRUE(unbroken == rows("b"));
}

TEST(AutomaticTimeStep, KeepsTheDynamicsAsTrialsShow) {
  ScratchDirectory const scratch;
  auto scene = tests::ideal_gas_scene("equilibrate = 64\nsteps = 640\n");
  scene.K = 10, scene.scheme = "dt = \"auto\"\ndynamics = \"5%\"\n";
  write_text_file(scratch / "s.toml", scene.text());
  auto const checked = program({"check", (scratch / "s.toml").string(), "--json"});
  ASSERT_EQ(checked.status, 0) << checked.errors;
  double const sure = Json::parse(checked.output)["dynamics_dt_reduced_at_least"];
  auto const result =
      program({"run", (scratch / "s.toml").string(), "-o", (scratch / "a").string(), "--no-report"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.errors.find("limited by the wanted dynamics; trials show"), std::string::npos)
      << result.errors;
  auto const summary = Json::parse(read_text_file(scratch / "a" / "summary.json"));
  auto const kept = summary["tolerances"]["dynamics"];
  double const dt = summary["dt_reduced"], bound = summary["diffusion_excess_at_most"];
  EXPECT_EQ(kept["by"], "trials");
  EXPECT_TRUE(kept["fulfilled"].get<bool>());
  EXPECT_GE(dt, sure);
  EXPECT_LT(dt, 0.3); // where twice the diffusion was seen
  EXPECT_LT(kept["found"].get<double>(), std::min(bound, 0.05));
  EXPECT_NE(result.output.find("of the tolerated 5%: fulfilled"), std::string::npos) << result.output;
  auto const again = program(
      {"run", (scratch / "a" / "scene.toml").string(), "-o", (scratch / "b").string(), "--no-report"});
  ASSERT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(Json::parse(read_text_file(scratch / "b" / "summary.json"))["tolerances"], summary["tolerances"]);
}

TEST(Reproduce, ListsWhatItHas) {
  auto const list = program({"reproduce", "list", "--json"});
  ASSERT_EQ(list.status, 0) << list.errors;
  EXPECT_GE(Json::parse(list.output)["reproductions"].size(), 10u);
  auto const unknown = program({"reproduce", "tabel-4.1"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("did you mean 'table-4.1'"), std::string::npos) << unknown.errors;
}

} // namespace
} // namespace mesobridge::workflows
