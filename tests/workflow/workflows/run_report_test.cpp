#include "scratch_directory.hpp"
#include "workflows/process.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <regex>

// What a reader finds in the report of a run.

namespace mesobridge::workflows {
namespace {

std::string report_of(std::filesystem::path const& directory, std::string const& scene,
                      std::vector<std::string> const& settings) {
  std::vector<std::string> words{
      MESOBRIDGE_PROGRAM, "run",    MESOBRIDGE_SOURCE_DIR "/workflows/scenes/" + scene + ".toml", "-o",
      directory.string(), "--quiet"};
  for (auto const& setting : settings)
    words.insert(words.end(), {"--set", setting});
  auto const done = run_process(words);
  EXPECT_EQ(done.status, 0) << done.errors;
  return read_text_file(directory / "report.html");
}

std::size_t drawings(std::string const& html) {
  static std::regex const drawing("<svg");
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(html.begin(), html.end(), drawing), std::sregex_iterator()));
}

TEST(RunReport, DrawsWhatWasAskedForAndLinksItsFiles) {
  tests::ScratchDirectory const scratch;
  std::vector<std::string> settings{"particles.K=20", "particles.density=plain", "run.equilibrate=64",
                                    "run.steps=400", "run.sample_every=5"};
  auto const plain = report_of(scratch / "plain", "argon-1000K", settings);
  EXPECT_EQ(drawings(plain), 4u + 3u) << "temperatures, pressure, density, energy; three distributions";
  EXPECT_EQ(plain.find("Profile of"), std::string::npos);
  settings.insert(settings.end(), {"profile.every=40", "profile.bins=10", "histogram.every=100"});
  auto const full = report_of(scratch / "full", "argon-1000K", settings);
  int found = 0;
  for (char const* const part :
       {"Temperatures in time", "Pressure in time", "Mean density in time", "Energy error", "Profile of rho",
        "Profile of T_kin", "Profile of velocity", "Distribution of eps",
        "Distribution of T over 5 histograms", "href=\"run.h5\"", "href=\"summary.json\"",
        "href=\"scene.toml\"", "<pre>title"}) {
    EXPECT_NE(full.find(part), std::string::npos) << part;
    ++found;
  }
  EXPECT_EQ(found, 13);
}

TEST(RunReport, OfDpdHasNoEnergies) {
  tests::ScratchDirectory const scratch;
  auto const html =
      report_of(scratch / "dpd", "dpd-fluid",
                {"particles.N=512", "run.equilibrate=64", "run.steps=320", "run.sample_every=5"});
  EXPECT_EQ(drawings(html), 2u) << "temperature and pressure";
  EXPECT_EQ(html.find("internal energy"), std::string::npos);
}

} // namespace
} // namespace mesobridge::workflows
