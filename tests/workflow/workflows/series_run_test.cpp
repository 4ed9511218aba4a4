#include "scratch_directory.hpp"
#include "sdpd/method/list.hpp"
#include "sdpd/observe/list.hpp"
#include "sdpd_scene.hpp"
#include "soft_scene.hpp"
#include "workflows/command.hpp"
#include "workflows/process.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

// What is asked of every measurement that a scene may name, whoever adds one, from the scene to the report.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

constexpr char const* run_keys = "sample_every = 4\ninstant_every = 20\nequilibrate = 64\nsteps = 640\n";

struct Method {
  std::string name, scene;
  sdpd::Features features;
};

tests::SdpdScene plain_gas() {
  auto scene = tests::ideal_gas_scene(run_keys);
  scene.particles = "density = \"plain\"\n";
  return scene;
}

std::vector<Method> const methods{
    {"sdpd", plain_gas().text(), sdpd::Sdpd::features},
    {"dpde", tests::SoftScene{.method = "dpde", .run = run_keys}.text(), sdpd::Dpde::features},
    {"dpd", tests::SoftScene{.method = "dpd", .run = run_keys}.text(), sdpd::Dpd::features}};

std::vector<sdpd::Measurement> asked_of(Method const& method) {
  std::vector<sdpd::Measurement> asked;
  for (auto const& measured : sdpd::measurements())
    if (!measured.in_every_run() && measured.exists(method.features))
      asked.push_back(measured);
  return asked;
}

/// All of them by their names, for some are measured only then.
std::string all_of(Method const& method) {
  std::vector<std::string> names;
  for (auto const& measured : asked_of(method))
    names.push_back(fmt::format("\"{}\"", measured.name));
  return fmt::format("series.quantities=[{}]", fmt::join(names, ", "));
}

/// mesobridge VERB on a method's scene with settings.
ProcessResult called(std::vector<std::string> words, std::filesystem::path const& folder,
                     Method const& method, std::vector<std::string> const& settings) {
  auto const scene = folder / (method.name + ".toml");
  write_text_file(scene, method.scene);
  words.insert(words.begin(), MESOBRIDGE_PROGRAM);
  words.push_back(scene.string());
  for (auto const& setting : settings)
    words.insert(words.end(), {"--set", setting});
  return run_process(words);
}

/// Runs into a folder; the exit code may be 3: short runs are not at equilibrium, and yet measured.
std::filesystem::path ran(std::filesystem::path const& folder, std::string const& name, Method const& method,
                          std::vector<std::string> const& settings,
                          std::vector<std::string> const& more = {}) {
  std::vector<std::string> words{"run", "--quiet", "--threads", "1", "-o", (folder / name).string()};
  words.insert(words.end(), more.begin(), more.end());
  auto const done = called(words, folder, method, settings);
  EXPECT_TRUE(done.status == 0 || done.status == 3) << done.errors;
  return folder / name;
}

/// The dataset of a measurement: its name, with the key of its unit.
std::string dataset_of(Store const& store, sdpd::Measurement const& measured) {
  for (char const* const end : {"", "_Pa", "_J", "_K", "_m_s", "_kg_m3", "_kg_m_s"})
    if (auto const name = fmt::format("series/{}{}", measured.name, end); store.contains(name))
      return name;
  ADD_FAILURE() << measured.name << " is not in the file";
  return "series/step";
}

/// "pressure_tensor_Pa" with the component xy: "pressure_tensor_xy_Pa".
std::string key_of(std::string const& dataset, sdpd::Measurement const& measured, std::size_t component) {
  auto const name = dataset.substr(std::string("series/").size());
  return std::string(measured.name) + std::string(measured.components[component]) +
         name.substr(measured.name.size());
}

TEST(SeriesOfARun, ReachFileSummaryAndReport) {
  ScratchDirectory const scratch;
  int components = 0;
  for (auto const& method : methods) {
    auto const folder = ran(scratch.path(), method.name, method, {"series.every=20", all_of(method)});
    Store const store(folder / "run.h5", Store::Mode::read);
    auto const summary = Json::parse(read_text_file(folder / "summary.json"));
    auto const report = read_text_file(folder / "report.html");
    constexpr std::size_t rows = 33;
    ASSERT_EQ(store.read_integers("series/step").size(), rows);
    for (auto const& measured : asked_of(method)) {
      auto const dataset = dataset_of(store, measured);
      std::size_t const count = measured.components.size();
      auto const values = store.read_doubles(dataset);
      ASSERT_EQ(values.size(), rows * count) << method.name << " " << measured.name;
      for (std::size_t c = 0; c < count; ++c, ++components) {
        double mean = 0;
        for (std::size_t r = 0; r < rows; ++r)
          mean += values[r * count + c] / rows;
        auto const key = key_of(dataset, measured, c);
        EXPECT_NEAR(summary.at(key).get<double>(), mean, 1e-12 * std::abs(mean) + 1e-300) << key;
        EXPECT_GE(summary.at(key + "_se").get<double>(), 0) << key;
      }
      auto spoken = std::string(measured.name);
      std::ranges::replace(spoken, '_', ' ');
      EXPECT_NE(report.find("<td>" + spoken), std::string::npos) << method.name << ": no row of " << spoken;
      EXPECT_NE(report.find(std::string(measured.name) + "</code>: "), std::string::npos) << spoken;
    }
  }
  EXPECT_GE(components, 4);
}

TEST(SeriesOfARun, AreNotThereUnlessTheSceneAsks) {
  ScratchDirectory const scratch;
  int looked = 0;
  for (auto const& method : methods) {
    auto const folder = ran(scratch.path(), method.name, method, {"series.every=0"}, {"--no-report"});
    EXPECT_FALSE(Store(folder / "run.h5", Store::Mode::read).contains("series"));
    EXPECT_EQ(read_text_file(folder / "scene.toml").find("series"), std::string::npos);
    auto const named = asked_of(method).front();
    auto const one =
        ran(scratch.path(), method.name + "-one", method,
            {"series.every=20", fmt::format("series.quantities=[\"{}\"]", named.name)}, {"--no-report"});
    Store const store(one / "run.h5", Store::Mode::read);
    for (auto const& measured : asked_of(method)) {
      auto const name = fmt::format("series/{}", measured.name);
      EXPECT_EQ(store.contains(name) || store.contains(name + "_Pa"), measured.name == named.name) << name;
      ++looked;
    }
    for (char const* const same : {"thermodynamics"})
      EXPECT_EQ(store.read_doubles(same),
                Store(folder / "run.h5", Store::Mode::read).read_doubles(same)); // to look changes nothing
  }
  EXPECT_GE(looked, 4);
}

TEST(SeriesOfARun, HaveTheSameBitsWhenResumed) {
  ScratchDirectory const scratch;
  int compared = 0;
  for (auto const& method : methods) {
    std::vector<std::string> const asked{"series.every=20", all_of(method)};
    auto const whole = ran(scratch.path(), method.name, method, asked, {"--no-report"});
    auto first = asked;
    first.emplace_back("run.steps=332"); // an end between two rows
    ran(scratch.path(), method.name + "-resumed", method, first, {"--no-report"});
    auto const resumed =
        ran(scratch.path(), method.name + "-resumed", method, asked, {"--no-report", "--resume"});
    Store const a(whole / "run.h5", Store::Mode::read), b(resumed / "run.h5", Store::Mode::read);
    EXPECT_EQ(a.read_integers("series/step"), b.read_integers("series/step"));
    for (auto const& measured : asked_of(method)) {
      auto const dataset = dataset_of(a, measured);
      EXPECT_EQ(a.read_doubles(dataset), b.read_doubles(dataset)) << dataset;
      ++compared;
    }
    auto const ends = Json::parse(read_text_file(whole / "summary.json")),
               resumed_ends = Json::parse(read_text_file(resumed / "summary.json"));
    EXPECT_EQ(ends, resumed_ends);
  }
  EXPECT_GE(compared, 4);
}

TEST(SeriesOfARun, TakeTheDiskThatCheckForetold) {
  ScratchDirectory const scratch;
  auto const& dpd = methods.back();
  double sizes[2], foretold[2];
  for (int k = 0; k < 2; ++k) {
    std::vector<std::string> const settings{"run.steps=4000", fmt::format("series.every={}", k)};
    auto const check = called({"check", "--json"}, scratch.path(), dpd, settings);
    ASSERT_EQ(check.status, 0) << check.errors;
    foretold[k] = Json::parse(check.output)["estimated_disk_bytes"].get<double>();
    auto const folder = ran(scratch.path(), fmt::format("dpd-{}", k), dpd, settings, {"--no-report"});
    sizes[k] = static_cast<double>(std::filesystem::file_size(folder / "run.h5"));
  }
  EXPECT_GT(sizes[1] - sizes[0], 4000.0 * 3 * 8); // step, time and a number at least
  EXPECT_NEAR((foretold[1] - foretold[0]) / (sizes[1] - sizes[0]), 1, 0.1);
}

TEST(SeriesOfARun, AreNamedByTheKeysAndRefusedByName) {
  ScratchDirectory const scratch;
  auto const keys = run_process({MESOBRIDGE_PROGRAM, "check", "--keys"});
  ASSERT_EQ(keys.status, 0) << keys.errors;
  int named = 0;
  for (auto const& measured : sdpd::measurements())
    if (!measured.in_every_run()) {
      auto const text = fmt::format("{} ({}", measured.name, measured.meaning);
      EXPECT_NE(keys.output.find(text), std::string::npos) << text;
      ++named;
    }
  EXPECT_GE(named, 2);

  int refused = 0;
  for (auto const& method : methods) {
    auto const misspelt = called({"check"}, scratch.path(), method,
                                 {"series.every=20", "series.quantities=[\"mean_neighbour\"]"});
    EXPECT_EQ(misspelt.status, 2);
    for (auto const& part : {"series.quantities", "mean_neighbour", "a list of some of", "mean_neighbours"})
      EXPECT_NE(misspelt.errors.find(part), std::string::npos) << misspelt.errors;
    for (auto const& measured : sdpd::measurements()) {
      if (measured.in_every_run() || measured.exists(method.features))
        continue;
      auto const foreign =
          called({"check"}, scratch.path(), method,
                 {"series.every=20", fmt::format("series.quantities=[\"{}\"]", measured.name)});
      EXPECT_EQ(foreign.status, 2);
      EXPECT_NE(foreign.errors.find("there is no such quantity"), std::string::npos) << foreign.errors;
      ++refused;
    }
    auto const rare = called({"check"}, scratch.path(), method, {"series.every=41"});
    EXPECT_EQ(rare.status, 2);
    EXPECT_NE(rare.errors.find("run.steps/16 = 40"), std::string::npos) << rare.errors;
  }
  EXPECT_GE(refused, 2);
}

} // namespace
} // namespace mesobridge::workflows
