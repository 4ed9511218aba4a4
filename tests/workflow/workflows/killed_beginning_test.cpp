#include "scratch_directory.hpp"
#include "unit/workflows/killed_process.hpp"
#include "workflows/process.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <chrono>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

// A run that is killed before its first sample - while its time step is studied, its densities are calibrated
// or it comes to equilibrium - and resumed ends with the bits of one that was left alone.

namespace mesobridge::workflows {
namespace {

using tests::killed_after;
using tests::ScratchDirectory;
namespace fs = std::filesystem;

/// A run that spends most of its time in one stage before the first sample.
struct Beginning {
  std::string scene;
  std::vector<std::string> settings;
  bool (*is_there)(fs::path const& folder); ///< whether a run that was killed was in that stage
};

Beginning study() {
  return {MESOBRIDGE_SOURCE_DIR "/workflows/scenes/dpd-fluid.toml",
          {"scheme.dt=auto", "scheme.bias=2 %", "particles.N=343", "run.equilibrate=20", "run.steps=320"},
          [](fs::path const& folder) {
            return fs::exists(folder / "dt-auto") && !fs::exists(folder / "scene.toml");
          }};
}

Beginning calibration() {
  return {
      MESOBRIDGE_SOURCE_DIR "/workflows/scenes/argon-1000K.toml",
      {"particles.N=343", "particles.K=20", "particles.density=calibrated", "particles.calibration_steps=400",
       "run.equilibrate=20", "run.steps=320"},
      [](fs::path const& folder) { return fs::exists(folder) && !fs::exists(folder / "calibration.json"); }};
}

Beginning equilibration() {
  return {MESOBRIDGE_SOURCE_DIR "/workflows/scenes/ideal-gas.toml",
          {"particles.N=343", "run.equilibrate=600", "run.checkpoint_every=20", "run.steps=320"},
          [](fs::path const& folder) {
            return fs::exists(folder / "scene.toml") && !fs::exists(folder / "run.h5");
          }};
}

/// The same in a Langevin bath, whose noise has to go on, too.
Beginning bath() {
  auto in_bath = equilibration();
  in_bath.settings.emplace_back("run.thermostat=langevin");
  return in_bath;
}

std::vector<std::string> words(Beginning const& beginning, fs::path const& folder) {
  std::vector<std::string> result{MESOBRIDGE_PROGRAM, "run",     beginning.scene, "-o",
                                  folder.string(),    "--quiet", "--threads",     "1",
                                  "--no-report"};
  for (auto const& setting : beginning.settings)
    result.insert(result.end(), {"--set", setting});
  result.emplace_back("--resume"); // of what has not begun, it begins it
  return result;
}

struct Results {
  std::vector<double> thermodynamics, moments;
  std::string summary, scene;
  bool operator==(Results const&) const = default;
};

Results results(fs::path const& folder) {
  Store const store(folder / "run.h5", Store::Mode::read);
  return {store.read_doubles("thermodynamics"),
          store.contains("moments") ? store.read_doubles("moments") : std::vector<double>(),
          read_text_file(folder / "summary.json"), read_text_file(folder / "scene.toml")};
}

/// Kills runs until so many died in their beginning, some of them twice; each then ends as the unbroken one.
void expect_bits_of_unbroken(Beginning const& beginning, int wanted, unsigned seed) {
  ScratchDirectory const scratch;
  auto const begin = std::chrono::steady_clock::now();
  auto const whole = run_process(words(beginning, scratch / "unbroken"));
  ASSERT_EQ(whole.status, 0) << whole.errors;
  auto const time =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
  auto const expected = results(scratch / "unbroken");
  ASSERT_GT(expected.thermodynamics.size(), 300u);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<std::int64_t> delay(1000, time.count());
  int kills = 0, ended = 0;
  for (int attempt = 0; kills < wanted && attempt < 10 * wanted; ++attempt) {
    auto const folder = scratch / fmt::format("broken-{}", attempt);
    auto const command = words(beginning, folder);
    for (int kill = 0; kill <= attempt % 2; ++kill) {
      killed_after(std::chrono::microseconds(delay(generator)), attempt % 3 == 0 ? SIGTERM : SIGKILL,
                   command);
      kills += beginning.is_there(folder);
    }
    auto const last = run_process(command);
    ASSERT_EQ(last.status, 0) << last.errors;
    ASSERT_TRUE(results(folder) == expected) << "attempt " << attempt;
    ++ended;
    fs::remove_all(folder);
  }
  EXPECT_GE(kills, wanted);
  std::cout << kills << " kills in " << ended << " runs\n";
}

TEST(KilledBeginning, OfACalibrationOfTheDensities) {
  expect_bits_of_unbroken(calibration(), 3, 32);
}
TEST(KilledBeginning, OfAnEquilibration) {
  expect_bits_of_unbroken(equilibration(), 4, 33);
}
TEST(KilledBeginning, OfAnEquilibrationInABath) {
  expect_bits_of_unbroken(bath(), 2, 34);
}
TEST(Long_KilledBeginning, AHundredTimes) {
  expect_bits_of_unbroken(study(), 20, 41);
  expect_bits_of_unbroken(calibration(), 35, 42);
  expect_bits_of_unbroken(equilibration(), 35, 43);
  expect_bits_of_unbroken(bath(), 10, 44);
}

} // namespace
} // namespace mesobridge::workflows
