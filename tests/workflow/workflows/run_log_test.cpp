#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/process.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

// What a run tells people: its last lines and log.txt, against the numbers in its files.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

std::vector<std::string> words(std::filesystem::path const& folder, std::vector<std::string> const& more) {
  std::vector<std::string> result{MESOBRIDGE_PROGRAM,
                                  "run",
                                  MESOBRIDGE_SOURCE_DIR "/workflows/scenes/argon-1000K.toml",
                                  "-o",
                                  folder.string(),
                                  "--threads",
                                  "1"};
  for (char const* set : {"particles.N=343", "run.equilibrate=64", "run.sample_every=5"})
    result.insert(result.end(), {"--set", set});
  result.insert(result.end(), more.begin(), more.end());
  return result;
}

/// The lines of thermodynamics of a log, as numbers.
std::vector<std::vector<double>> thermo(std::string const& log) {
  std::vector<std::vector<double>> rows;
  std::istringstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("  ")) // other lines begin with a date or a name
      continue;
    std::istringstream numbers(line);
    std::vector<double> row;
    for (double value = 0; numbers >> value;)
      row.push_back(value);
    if (!row.empty())
      rows.push_back(row);
  }
  return rows;
}

TEST(RunLog, HoldsTheNumbersOfTheSamples) {
  ScratchDirectory const scratch;
  auto const folder = scratch / "out";
  auto const result =
      run_process(words(folder, {"--set", "run.steps=1000", "--set", "particles.start=melted", "--quiet"}));
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(result.errors.empty() || result.errors.starts_with("warning: means rest on few"))
      << result.errors;
  EXPECT_LE(std::ranges::count(result.errors, '\n'), 1) << result.errors;
  auto const log = read_text_file(folder / "log.txt");
  for (std::string const text : {"mesobridge run ", "argon-1000K.toml", "1 thread(s)", "Argon at 1000 K",
                                 "T_kin[K]", "rho[kg/m^3]", "end\n"})
    EXPECT_NE(log.find(text), std::string::npos) << text << "\n" << log;

  auto const rows = thermo(log);
  ASSERT_EQ(rows.size(), 21u) << log; // every 50 steps
  Store const store(folder / "run.h5", Store::Mode::read);
  auto const samples = store.read_doubles("thermodynamics"); // every 5 steps
  constexpr std::size_t columns = 12, step = 0, time = 1, T_kin = 5, P = 7, rho = 8;
  ASSERT_EQ(samples.size(), 201 * columns);
  int compared = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    ASSERT_EQ(rows[k].size(), 7u);
    auto const sample = [&](std::size_t column) { return samples[10 * k * columns + column]; };
    for (auto const& [place, column] :
         {std::pair<std::size_t, std::size_t>{0, step}, {1, time}, {2, T_kin}, {4, P}, {5, rho}})
      EXPECT_NEAR(rows[k][place], sample(column), 1e-8 * std::abs(sample(column))) << k << " " << column;
    ++compared;
  }
  EXPECT_EQ(compared, 21);
}

TEST(RunLog, TheRunEndsWithItsResults) {
  ScratchDirectory const scratch;
  auto const folder = scratch / "out";
  auto const result = run_process(words(folder, {"--set", "run.steps=400"}));
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const summary = Json::parse(read_text_file(folder / "summary.json"));
  int compared = 0;
  for (auto const& [name, key] : {std::pair<std::string, std::string>{"T_kin", "T_kin_K"},
                                  {"T_int", "T_int_K"},
                                  {"P", "P_Pa"},
                                  {"rho", "rho_kg_m3"},
                                  {"e", "e_J_kg"}}) {
    std::smatch found; // "P  (1.512 ± 0.007)e8 Pa" or "rho  1191.3 ± 3.2 kg/m^3"
    ASSERT_TRUE(
        std::regex_search(result.output, found,
                          std::regex("(^|\n)" + name + R"( +\(?(-?[0-9.]+) ± ([0-9.]+)(\)e(-?[0-9]+))? )")))
        << name << "\n"
        << result.output;
    double const unit = found[5].matched ? std::pow(10, std::stod(found[5])) : 1;
    double const mean = summary[key], se = summary[key + "_se"];
    EXPECT_NEAR(std::stod(found[2]) * unit, mean, 0.06 * se) << name;
    EXPECT_NEAR(std::stod(found[3]) * unit, se, 0.06 * se) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
  EXPECT_TRUE(result.output.ends_with("report.html\n")) << result.output;
  // Who keeps stderr in a file sees the lines of thermodynamics there.
  EXPECT_EQ(thermo(result.errors).size(), 21u) << result.errors;
}

TEST(RunLog, ARunThatGoesOnAppends) {
  ScratchDirectory const scratch;
  auto const folder = scratch / "out";
  std::vector<std::string> const more{"--set", "run.steps=6000", "--set", "run.checkpoint_every=100",
                                      "--quiet"};
  auto stopped = words(folder, more);
  // once its log has begun, however busy the machine is
  auto const wait = R"(log=$1; shift; "$@" & run=$!; until [ -s "$log" ]; do sleep 0.05; done
                       kill -TERM $run; wait $run)";
  stopped.insert(stopped.begin(), {"sh", "-c", wait, "sh", (folder / "log.txt").string()});
  ASSERT_EQ(run_process(stopped).status, 130);
  auto const first = read_text_file(folder / "log.txt");
  EXPECT_NE(first.find("stopped"), std::string::npos) << first;
  auto resumed = words(folder, more);
  resumed.emplace_back("--resume");
  ASSERT_EQ(run_process(resumed).status, 0);
  auto const both = read_text_file(folder / "log.txt");
  EXPECT_TRUE(both.starts_with(first));
  auto const rows = thermo(both);
  EXPECT_EQ(rows.back()[0], 6000);
  EXPECT_GE(rows.size(), 21u);
}

} // namespace
} // namespace mesobridge::workflows
