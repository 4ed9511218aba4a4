#include "fitting/fit_family.hpp"
#include "fitting/model_file.hpp"
#include "program.hpp"
#include "scratch_directory.hpp"
#include "unit/fitting/random_states.hpp"
#include "workflows/command.hpp"
#include "workflows/provenance.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

// These tests run the program itself, as a user would.

namespace mesobridge::workflows {
namespace {

using tests::program;
using tests::ScratchDirectory;

std::string const data = MESOBRIDGE_SOURCE_DIR "/workflows/data/";

std::vector<std::string> const tin_words{
    "fit",         "mie-gruneisen", data + "tin-us-up.csv", "--m0",  "118.71 u", "--fix",
    "Gamma_0=2.3", "--fix",         "Gamma_inf=0",          "--fix", "q=1",      "--fix",
    "c_v=210"};

std::vector<std::string> with(std::vector<std::string> words, std::vector<std::string> const& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(FitEosCommand, TinFromItsShockLine) {
  ScratchDirectory const scratch;
  auto const model = scratch / "tin.toml";
  auto const result = program(with(tin_words, {"-o", model, "--json", "--bootstrap", "50"}));
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  EXPECT_EQ(json["undetermined"].size(), 0u);
  EXPECT_TRUE(json["converged"].get<bool>());
  EXPECT_EQ(json["observations"].size(), 13u);
  EXPECT_LT(json["chi_2"].get<double>(), 10); // exact points, but the model's v_S(v_P) is not quite straight
  for (auto const& observation : json["observations"])
    for (auto const* const quantity : {"v_S_deviation", "P_deviation"})
      EXPECT_LT(std::abs(observation.value(quantity, 0.0)), 2) << observation;
  // K_s = rho_0 c_0^2 = 4.97e10 Pa and N_s = 4 s - 1 = 4.96 where the line is a tangent; over all of it the
  // curved model comes within 10 %.
  auto const& K_s = json["parameters"]["K_s"];
  EXPECT_NEAR(K_s["value"].get<double>() / 4.97e10, 1, 0.1);
  EXPECT_NEAR(json["parameters"]["N_s"]["value"].get<double>() / 4.96, 1, 0.12);
  EXPECT_NEAR(K_s["bootstrap_se"].get<double>() / K_s["value_se"].get<double>(), 1, 0.4);

  // The report and the model are there; every command takes the model by its path.
  auto const report = read_text_file(scratch / "tin.html");
  EXPECT_NE(report.find("<svg"), std::string::npos);
  EXPECT_NE(report.find("Correlation"), std::string::npos);
  auto const state = program({"eos", "eval", "--model", model, "--rho", "9000", "--T", "1000", "--json"});
  ASSERT_EQ(state.status, 0) << state.errors;
  EXPECT_GT(Json::parse(state.output)["P_Pa"].get<double>(), 1e10);
  auto const file = fitting::parse_model(read_text_file(model), model);
  EXPECT_EQ(file.data_hash, sha256_of_file(data + "tin-us-up.csv"));
  EXPECT_EQ(file.fitted, (std::vector<std::string>{"rho_s_kg_m3", "K_s_Pa", "N_s"}));
  EXPECT_NEAR(std::get<fitting::MieGruneisen>(file.eos).parameters().m0, 118.71 * atomic_mass, 1e-30);
}

TEST(FitEosCommand, NitromethaneFromItsShockLine) {
  ScratchDirectory const scratch;
  auto const result =
      program({"fit", "hz", data + "nitromethane-us-up.csv", "--from", "nitromethane", "--fix", "Gamma_0=1",
               "--fix", "c_v=1211", "-o", scratch / "nm.toml", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const parameters = Json::parse(result.output)["parameters"];
  // HZ is made so that v_S = c_0 + s v_P nearly holds: the line comes back.
  int compared = 0;
  for (auto const& [name, value] :
       std::map<std::string, double>{{"c_0", 1650}, {"s", 1.64}, {"rho_0", 1125}}) {
    auto const& parameter = parameters[name];
    EXPECT_NEAR(parameter["value"].get<double>(), value, 1.5 * parameter["value_se"].get<double>()) << name;
    EXPECT_NEAR(parameter["value"].get<double>() / value, 1, 0.005) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

TEST(FitEosCommand, EveryKindReturnsItsMaterialFromStatesOfIt) {
  ScratchDirectory const scratch;
  std::size_t kinds = 0;
  fitting::for_each_described_model([&]<class Model>() {
    auto const& description = Model::description();
    if (!description.fittable())
      return;
    SCOPED_TRACE(description.kind);
    std::string const kind(description.kind), name(description.materials.front().name);
    auto const table = scratch / (kind + ".csv"), file = scratch / (kind + ".toml");
    Model const truth(description.materials.front().parameters);
    double const rho = fitting::test::typical_density(truth);
    std::string states = "rho_kg_m3,T_K,P_Pa,e_J_kg\n";
    for (double const x : {1.05, 1.1, 1.15, 1.2, 1.3, 1.4})
      for (double const T : {1500.0, 2000.0, 3000.0, 4000.0}) {
        auto const isochore = truth.isochore(x * rho);
        states += fmt::format("{},{},{},{}\n", x * rho, T, isochore.pressure(T), isochore.energy(T));
      }
    write_text_file(table, states);
    auto const fitted =
        program({"fit", kind, table, "--from", name, "--relative-error", "0.01", "--local", "-o", file});
    ASSERT_EQ(fitted.status, 0) << fitted.errors;
    auto const model = std::get<Model>(fitting::parse_model(read_text_file(file), file).eos);
    for (double const x : {1.1, 1.3})
      for (double const T : {1600.0, 3900.0})
        EXPECT_NEAR(model.isochore(x * rho).pressure(T) / truth.isochore(x * rho).pressure(T), 1, 1e-3);
    ++kinds;
  });
  EXPECT_EQ(kinds, fitting::fittable_kinds().size());
  EXPECT_GE(kinds, 3u);
}

TEST(FitEosCommand, TheSameSeedGivesTheSameModel) {
  ScratchDirectory const scratch;
  auto const fit = [&](std::string const& seed, std::string const& name) {
    auto const result = program(with(tin_words, {"-o", scratch / name, "--seed", seed, "--json"}));
    EXPECT_EQ(result.status, 0) << result.errors;
    return Json::parse(result.output)["parameters"].dump();
  };
  EXPECT_EQ(fit("3", "a.toml"), fit("3", "b.toml"));
}

TEST(FitEosCommand, BadInputHasACodeAndOneClearMessage) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "bad.csv", "rho_kg_m3,T_K,P_Pa\n8000,900,5e9\n");
  write_text_file(scratch / "few.csv", "rho_kg_m3,T_K,P_Pa,P_se_Pa\n8000,900,5e9,1e7\n");
  auto const tin = data + "tin-us-up.csv";
  struct Case {
    std::vector<std::string> words;
    int code;
    std::string message;
  };
  std::vector<Case> const cases{
      {{"fit", "mie-gruneisen", tin}, 2, "--m0 = nothing: the mass of one atom or molecule must be given"},
      {{"fit", "mie-gruneisen", tin, "--m0", "118 kg/m^3"}, 2, "--m0 '118 kg/m^3'"},
      {{"fit", "mie-gruneisen", "/no/such.csv", "--m0", "1 u"}, 2, "cannot read '/no/such.csv'"},
      {{"fit", "mie-gruneisen", scratch / "bad.csv", "--m0", "1 u"}, 2, "bad.csv:2: P has no standard error"},
      {{"fit", "mie-gruneisen", scratch / "few.csv", "--m0", "1 u"}, 2, "number of data = 1"},
      {{"fit", "hz", tin, "--m0", "1 u", "--fix", "K_s=1"}, 2, "hz has no parameter 'K_s'"},
      {{"fit", "hz", tin, "--m0", "1 u", "--fix", "s"}, 2, "--fix = s: must have the form name=value"},
      {{"fit", "hz", tin, "--m0", "1 u", "--bound", "s=1"}, 2, "must have the form low:high"},
      {{"fit", "hz", tin, "--m0", "1 u", "--bound", "s=3:1"}, 2, "s bounds = 3:1"},
      {{"fit", "hz", tin, "--from", "tin"}, 2, "must be hz"},
      {{"fit", "jwl", tin, "--m0", "1 u", "--relative-error", "7"}, 2, "must be a fraction"},
      {{"fit", "hz", tin, "--m0", "1 u", "--region-rho", "1:2"}, 2, "must be given together"},
      {{"fit", "hz", tin, "--from", "nitromethane", "--local"}, 3, "at the start values"},
  };
  int ran = 0;
  for (auto const& [words, code, message] : cases) {
    tests::expect_refusal(program(with(words, {"-o", scratch / "model.toml"})), code, message);
    ++ran;
  }
  EXPECT_EQ(ran, 13);
}

} // namespace
} // namespace mesobridge::workflows
