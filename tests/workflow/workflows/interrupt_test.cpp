#include "fitting/fit_family.hpp"
#include "long_inputs.hpp"
#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/command/list.hpp"
#include <chrono>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <memory>
#include <set>

// A first signal ends every command that can run for long within two seconds, by exit code 130 and a message,
// and leaves nothing half written. Commands that run LAMMPS or the engine: tests/cases/signals.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

struct LongCommand {
  std::string name;
  Words words; ///< in a folder where inputs are in in/, for results in out/
};

std::string const data = MESOBRIDGE_SOURCE_DIR "/workflows/data/";

Words after(Words words, Words const& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<LongCommand> curves() {
  Words const many{"--points", "100000", "-o", "out/curve.svg"};
  Words const at_rest{"--model", "argon", "--rho0", "1150", "--T0", "500"};
  Words const explosive{"--reactant", "nitromethane", "--product", "nitromethane-products",
                        "--rho0",     "1104",         "--T0",      "300",
                        "--q",        "4.716e6",      "--P-max",   "3e10"};
  return {{"eos hugoniot", after(at_rest, after({"--vp", "500"}, many))},
          {"eos isentrope", after(at_rest, after({"--rho", "1600"}, many))},
          {"eos crussard", after(explosive, many)},
          {"eos riemann", after({"--left", "argon", "--rho-left", "1150", "--T-left", "500", "--right",
                                 "argon", "--rho-right", "800", "--T-right", "500"},
                                many)},
          {"eos plot",
           after({"--model", "argon", "--T", "300", "1000", "--rho-min", "800", "--rho-max", "1700"}, many)},
          {"eos table",
           {"--model", "argon", "--rho-min", "100", "--rho-max", "1700", "--rho-points", "2000", "--T-min",
            "200", "--T-max", "3000", "--T-points", "2000", "-o", "out/table.h5"}}};
}

std::vector<LongCommand> fits() {
  std::vector<LongCommand> all{{"fit lj-bwr", {"in/state-grid.h5", "--fit-gamma", "-o", "out/lj.toml"}},
                               {"fit dpde", {"in/vacuum.h5", "--order", "5", "-o", "out"}}};
  for (auto const& kind : fitting::fittable_kinds())
    all.push_back(
        {"fit " + kind.name,
         {data + "tin-us-up.csv", "--m0", "118.71 u", "--bootstrap", "1000000", "-o", "out/model.toml"}});
  return all;
}

std::vector<LongCommand> analyses() {
  return {{"cg state-grid", {"in/lj-grid.h5", "-o", "out"}},
          {"cg correlations", {"in/melt.h5", "--pair-stride", "1", "-o", "out"}},
          {"cg potential", {"in/melt.h5", "--cutoff", "2", "--steps", "100000", "-o", "out"}},
          {"cg friction", {"in/held.h5", "-o", "out"}},
          {"cg entropy", {"--vacuum", "in/vacuum.h5", "--order", "5", "-o", "out"}},
          {"cg blobs",
           {"in/long.lammpstrj", "--mapping", MESOBRIDGE_SOURCE_DIR "/tests/cases/dump/dimer.toml", "--dt",
            "0.005", "-o", "out"}}};
}

std::vector<LongCommand> long_commands() {
  std::vector<LongCommand> all;
  for (auto const& some : {curves(), fits(), analyses()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

class Interrupts : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    place_ = std::make_unique<ScratchDirectory>();
    auto const in = *place_ / "in";
    fs::create_directories(in);
    tests::write_many_states(in / "state-grid.h5");
    tests::write_long_series(in / "lj-grid.h5", 40, 40000);
    tests::write_many_blobs(in / "melt.h5", "melt", 1000, 300);
    tests::write_many_blobs(in / "vacuum.h5", "vacuum canonical", 400, 6000);
    tests::write_many_held(in / "held.h5", 1500, 4, 500);
    tests::write_long_dump(in / "long.lammpstrj", 400);
  }
  static void TearDownTestSuite() { place_.reset(); }

  /// Runs it in the scratch folder; a signal comes after one second, and the end must within two more.
  static ProcessResult signalled(LongCommand const& command, std::string const& signal) {
    fs::remove_all(*place_ / "out");
    fs::create_directories(*place_ / "out");
    Words words{"env",  "-C", place_->path().string(), "timeout", "--preserve-status", "-k", "2", "-s",
                signal, "1",  MESOBRIDGE_PROGRAM};
    auto const space = command.name.find(' ');
    words.push_back(command.name.substr(0, space));
    words.push_back(command.name.substr(space + 1));
    return run_process(after(words, command.words));
  }

  static Words left_behind() {
    Words files;
    for (auto const& entry : fs::recursive_directory_iterator(*place_ / "out"))
      if (!entry.is_directory())
        files.push_back(entry.path().filename().string());
    return files;
  }

  static std::unique_ptr<ScratchDirectory> place_;
};

std::unique_ptr<ScratchDirectory> Interrupts::place_;

TEST_F(Interrupts, EndEveryLongCommandWithinTwoSeconds) {
  int ended = 0;
  for (auto const& command : long_commands()) {
    auto const result = signalled(command, ended % 2 == 0 ? "TERM" : "INT");
    EXPECT_EQ(result.status, 130) << command.name << ": " << result.output << result.errors;
    EXPECT_NE(result.errors.find("mesobridge: "), std::string::npos) << command.name;
    EXPECT_NE(result.errors.find("interrupted"), std::string::npos) << command.name << result.errors;
    EXPECT_EQ(left_behind(), Words{}) << command.name << fmt::format("{}", fmt::join(left_behind(), " "));
    ++ended;
  }
  EXPECT_EQ(ended, 19);
}

/// Those of one state or one file, over in less than a second whatever they are given.
std::set<std::string> const short_ones{
    "eos eval",      "eos list", "eos jwl",    "eos cj", "eos profile",  "eos znd",     "eos explosion",
    "eos induction", "new",      "check",      "doctor", "cg transport", "cg exchange", "cg mapping",
    "report",        "schema",   "completion", "man",    "lammps-plugin"};

TEST_F(Interrupts, EveryCommandOfTheListIsTriedOrShort) {
  std::set<std::string> tried;
  for (auto const& command : long_commands())
    tried.insert(command.name);
  auto const cases = read_text_file(MESOBRIDGE_SOURCE_DIR "/tests/cases/signals/cases.toml");
  int known = 0;
  for (auto const& command : commands()) {
    bool const of_cases = cases.find("$MESOBRIDGE " + command.name + " ") != std::string::npos;
    EXPECT_TRUE(tried.contains(command.name) || of_cases || short_ones.contains(command.name))
        << command.name;
    ++known;
  }
  EXPECT_GE(known, 36);
}

} // namespace
} // namespace mesobridge::workflows
