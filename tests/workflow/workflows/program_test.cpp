#include "fitting/eos/list.hpp"
#include "interrupted_run.hpp"
#include "refusals.hpp"
#include "scratch_directory.hpp"
#include "workflows/provenance.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

// These tests run the program itself, as a user would.

namespace mesobridge::workflows {

namespace {

using tests::program;
using tests::ScratchDirectory;

std::string const scenes = MESOBRIDGE_SOURCE_DIR "/workflows/scenes/";

TEST(Program, EvaluatesAnIdealGasOfAnyGamma) {
  // Air as a diatomic gas: c^2 = gamma P/rho.
  int cases = 0;
  for (std::vector<std::string> const& gas : {std::vector<std::string>{"--gamma", "1.4"}, {"--dof", "5"}}) {
    std::vector<std::string> words{"eos", "eval", "--model", "ideal-gas", "--rho", "1.2",
                                   "--T", "300",  "--m0",    "4.81e-26",  "--json"};
    words.insert(words.end(), gas.begin(), gas.end());
    auto const result = program(words);
    ASSERT_EQ(result.status, 0) << result.errors;
    auto const json = Json::parse(result.output);
    double const P = json["P_Pa"], c = json["sound_speed_m_s"];
    EXPECT_NEAR(P, 1.2 * 1.380649e-23 * 300 / 4.81e-26, 1e-6 * P);
    EXPECT_NEAR(c, std::sqrt(1.4 * P / 1.2), 1e-9 * c);
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

TEST(Program, ListsEveryModelWithItsDomain) {
  auto const json = Json::parse(program({"eos", "list", "--json"}).output);
  ASSERT_EQ(json["models"].size(), fitting::materials().size());
  std::size_t cases = 0;
  for (auto const& model : json["models"]) {
    bool const reduced = model["name"].get<std::string>().starts_with("lj");
    EXPECT_TRUE(model.contains(reduced ? "rho_max" : "rho_max_kg_m3"));
    EXPECT_GT(model["edge"].get<std::string>().size(), 10u);
    ++cases;
  }
  EXPECT_GE(cases, 9u);
}

TEST(Program, TimesTheEquationsOfState) {
  auto const result = program({"bench", "eos", "--states", "64", "--repeats", "1", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  constexpr std::size_t mixtures = 2, calls_of_mixtures = 3; // one by each law for volumes
  EXPECT_EQ(json["ns_per_call"].size(), fitting::materials().size() + mixtures);
  std::size_t cases = 0;
  for (auto const& [model, calls] : json["ns_per_call"].items())
    for (auto const& [call, ns] : calls.items()) {
      EXPECT_GT(ns.get<double>(), 0) << model << " " << call;
      ++cases;
    }
  EXPECT_EQ(cases, 6 * fitting::materials().size() + calls_of_mixtures * mixtures);
}

TEST(Program, BadInputHasACodeAndOneClearMessage) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "bad.toml", "title = \"x\"\n[fluid]\nrhp = 1\n");
  auto const argon = scenes + "argon-1000K.toml";
  std::vector<tests::Refusal> const cases{
      {{"chekc"}, 2, "did you mean 'check'?"},
      {{"eos", "evla"}, 2, "did you mean 'eos eval'?"},
      {{"check", "/no/such/scene.toml"}, 2, "cannot read '/no/such/scene.toml': No such file or directory"},
      {{"check", scratch / "bad.toml"}, 2, "bad.toml:3: unknown key 'fluid.rhp'; did you mean 'rho'?"},
      {{"check", argon, "--set", "fluid.rho=-1150 kg/m^3"}, 2, "--set: fluid.rho"},
      {{"check", argon, "--set", "fluid.rho=1150 kg"}, 2, "wrong unit 'kg'"},
      {{"check", argon, "--set", "particles.K=0.5"}, 2, ">= 1"},
      {{"eos", "eval", "--model", "argon", "--rho", "-1", "--T", "1000"}, 2, "--rho = -1: must be > 0"},
      {{"eos", "eval", "--model", "argon", "--rho", "nan", "--T", "1000"}, 2, "--rho = nan"},
      {{"eos", "eval", "--model", "argon", "--rho", "1150"}, 2, "exactly one of them"},
      {{"eos", "eval", "--model", "argom", "--rho", "1150", "--T", "1000"}, 2, "argom"},
      {{"eos", "eval", "--model", "argon", "--rho", "1e6", "--T", "1000"}, 3, "outside"},
      {{"eos", "eval", "--model", "tin", "--gamma", "1.4", "--rho", "7000", "--T", "300"}, 2, "ideal gas"},
      {{"eos", "eval", "--model", "ideal-gas", "--gamma", "1", "--rho", "1", "--T", "300"}, 2, "gamma = 1"},
      {{"eos", "eval", "--model", "nitromethane", "--rho", "2280", "--T", "300"}, 3, "outside 0 < rho"},
      {{"eos", "eval", "--model", "lj-thol", "--rho", "0.3", "--T", "1"}, 3, "outside 1.2 <= T*"},
      {{"bench", "eos", "--model", "argom"}, 2, "argom"},
      {{"cg", "state-grid", "/no/such.h5"}, 2, "/no/such.h5"},
      {{"cg", "state-grid", scratch / "bad.toml"}, 2, "not an HDF5 file"},
      {{"fit", "lj-bwr", scratch / "bad.toml"}, 2, "not an HDF5 file"},
      {{"md", "lj-grid", "--cutoff", "-1", "-o", scratch / "x"}, 2, "cut-off = -1"},
      {{"md", "lj-grid", "--T-min", "5", "--T-max", "4", "-o", scratch / "x"}, 2, "temperature"},
      {{"md", "lj-grid", "-o", "/dev/null/x"}, 4, "/dev/null/x"},
  };
  EXPECT_EQ(tests::expect_refusals(cases), 23);
}

TEST(Program, JsonIsOneObjectOnStdout) {
  std::vector<std::vector<std::string>> const commands{
      {"doctor", "--json"},
      {"eos", "list", "--json"},
      {"eos", "eval", "--model", "argon", "--rho", "1150", "--T", "1000", "--json"},
      {"check", scenes + "argon-1000K.toml", "--json"},
      {"check", "--keys", "--json"},
  };
  int ran = 0;
  for (auto const& words : commands) {
    auto const result = program(words);
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_TRUE(Json::parse(result.output).is_object()); // parse refuses text behind the object
    ++ran;
  }
  EXPECT_EQ(ran, 5);
}

TEST(Program, EosEvalGivesThePublishedValues) {
  auto const lj =
      Json::parse(program({"eos", "eval", "--model", "lj", "--rho", "0.6", "--T", "1.35", "--json"}).output);
  EXPECT_NEAR(lj["alpha_r"], -1.237403479, 1e-9); // Johnson et al. 1993
  auto const argon = Json::parse(
      program({"eos", "eval", "--model", "argon", "--rho", "1150", "--T", "1000", "--json"}).output);
  // The reference values are for m0 = 6.63e-26 kg (fitting/README.md): 0.15 % denser in reduced units.
  EXPECT_NEAR(argon["P_Pa"], 0.68139e9, 0.005e9);
  EXPECT_NEAR(argon["e_J_kg"].get<double>() * 6.64e-26 / (1.380649e-23 * 1000), 1.26554, 0.001);
  for (auto const* key : {"e_J_kg", "P_Pa", "s_J_kg_K", "c_v_J_kg_K", "sound_speed_m_s"})
    EXPECT_TRUE(argon.contains(key)) << key;
}

TEST(Program, HelpShowsAnExampleOfEveryCommand) {
  auto const overview = program({"--help"});
  EXPECT_EQ(overview.status, 0);
  int ran = 0;
  for (auto const* name :
       {"md lj-grid", "cg state-grid", "fit lj-bwr", "eos eval", "eos list", "check", "doctor"}) {
    EXPECT_NE(overview.output.find(name), std::string::npos);
    std::istringstream words(name);
    std::vector<std::string> const split{std::istream_iterator<std::string>(words), {}};
    auto with_help = split;
    with_help.push_back("--help");
    auto const help = program(with_help);
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.output.find(std::string("mesobridge ") + name), std::string::npos);
    EXPECT_NE(help.output.find("Example:"), std::string::npos);
    ++ran;
  }
  EXPECT_EQ(ran, 7);
}

std::vector<std::string> small_grid(std::string const& directory, std::string const& ranks,
                                    std::string const& steps) {
  return {"md",
          "lj-grid",
          "--atoms",
          "256",
          "--cutoff",
          "2.5",
          "--densities",
          "2",
          "--temperatures",
          "2",
          "--T-max",
          "6",
          "--sampling-steps",
          steps,
          "--ranks",
          ranks,
          "-o",
          directory,
          "--seed",
          "3",
          "--json"};
}

TEST(Program, FromMdToAFittedModel) {
  ScratchDirectory const scratch;
  auto const sampled = program(small_grid(scratch / "two", "2", "3000"));
  ASSERT_EQ(sampled.status, 0) << sampled.errors;
  EXPECT_EQ(Json::parse(sampled.output)["states"], 4);
  ASSERT_EQ(program(small_grid(scratch / "one", "1", "3000")).status, 0);

  // The samples do not depend on the number of ranks.
  Store const two(scratch / "two/lj-grid.h5", Store::Mode::read),
      one(scratch / "one/lj-grid.h5", Store::Mode::read);
  auto const states = two.list("states");
  EXPECT_EQ(states.size(), 4u);
  for (auto const& state : states)
    EXPECT_EQ(two.read_doubles("states/" + state + "/P"), one.read_doubles("states/" + state + "/P"));
  EXPECT_GE(two.read_doubles("states/0000/P").size(), 300u);
  EXPECT_NE(two.read_text_attribute("provenance", "command").find("--atoms 256"), std::string::npos);

  auto const analysed = program({"cg", "state-grid", scratch / "two/lj-grid.h5", "--json"});
  ASSERT_EQ(analysed.status, 0) << analysed.errors;
  auto const table = Json::parse(analysed.output)["states"];
  ASSERT_EQ(table.size(), 4u);
  for (auto const& state : table) // inside the range that the published equation was fitted to
    EXPECT_GT(state["P_se"], 0);

  auto const model = (scratch / "model.toml").string();
  auto const fitted = program({"fit", "lj-bwr", scratch / "two/state-grid.h5", "-o", model, "--json"});
  ASSERT_EQ(fitted.status, 0) << fitted.errors;
  auto const numbers = Json::parse(fitted.output);
  for (auto const* key : {"chi_2", "degrees_of_freedom", "effective_parameters", "held_out_fraction"})
    EXPECT_TRUE(numbers.contains(key)) << key;
  auto const ours =
      Json::parse(program({"eos", "eval", "--model", model, "--rho", "0.7", "--T", "4", "--json"}).output);
  auto const published =
      Json::parse(program({"eos", "eval", "--model", "lj", "--rho", "0.7", "--T", "4", "--json"}).output);
  EXPECT_NEAR(ours["P"].get<double>() / published["P"].get<double>(), 1, 0.05);
  EXPECT_NE(ours["P"], published["P"]);
}

TEST(Program, AnInterruptedRunSaysSoAndKeepsItsSamples) {
  ScratchDirectory const scratch;
  int ran = 0;
  for (std::string const ranks : {"1", "2"}) {
    auto const file = scratch / (ranks + "/lj-grid.h5");
    tests::expect_interrupted(small_grid(scratch / ranks, ranks, "2000000"),
                              "interrupted; what was sampled is in", file, "P");
    EXPECT_EQ(Store(file, Store::Mode::read).read_integer_attribute("settings", "complete"), 0);
    ++ran;
  }
  EXPECT_EQ(ran, 2);
}

} // namespace

} // namespace mesobridge::workflows
