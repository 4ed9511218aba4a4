#include "scratch_directory.hpp"
#include "workflows/json_file.hpp"
#include "workflows/process.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numeric>

// A fluid that burns, from the scene to its files.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

constexpr char const* burning = R"(title = "burning"
[fluid]
eos = "nitromethane"
rho = "1700 kg/m^3"
T = "2500 K"
[particles]
N = 512
K = 100
density = "plain"
[reaction]
product = "nitromethane-products"
heat_per_molecule = "4.78e-19 J"
Z = "1e15 1/s"
E_a = "3e-19 J"
progress = 0.3
[transport]
eta = "1e-2 Pa*s"
[scheme]
dt = 0.01
[run]
steps = 64
sample_every = 2
trajectory_every = 30
checkpoint_every = 30
[profile]
axis = "z"
bins = 4
every = 20
[histogram]
every = 20
)";

ProcessResult ran(std::filesystem::path const& folder, std::string const& name,
                  std::vector<std::string> const& settings = {}) {
  auto const scene = folder / "burning.toml";
  write_text_file(scene, burning);
  std::vector<std::string> words{
      MESOBRIDGE_PROGRAM,      "run", scene.string(), "--quiet", "--json", "--threads", "1", "-o",
      (folder / name).string()};
  for (auto const& setting : settings)
    words.insert(words.end(), {"--set", setting});
  return run_process(words);
}

TEST(ReactionRun, WritesTheProgressEverywhere) {
  ScratchDirectory const scratch;
  auto const done = ran(scratch.path(), "run");
  ASSERT_TRUE(done.status == 0 || done.status == 3) << done.errors;
  Store const store(scratch.path() / "run" / "run.h5", Store::Mode::read);
  auto const series = store.read_doubles("thermodynamics/progress");
  ASSERT_EQ(series.size(), 32u);
  EXPECT_GT(series.front(), 0.3);
  EXPECT_GT(series.back(), series.front());
  EXPECT_LT(series.back(), 1);
  auto const chemical = store.read_doubles("thermodynamics/chemical_energy_J");
  EXPECT_LT(chemical.back(), chemical.front());
  auto const energy = store.read_doubles("thermodynamics/energy_J");
  EXPECT_NEAR(energy.back(), energy.front(), 1e-3 * chemical.front());
  EXPECT_EQ(store.read_doubles("profile/progress").size(), 3u * 4);
  auto const counts = store.read_integers("histogram/progress/counts"),
             above = store.read_integers("histogram/progress/above");
  ASSERT_EQ(counts.size(), 3u * 50); // from 0 to 1, so that all particles are in it
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}), 3 * 512);
  EXPECT_EQ(above, (std::vector<std::int64_t>{0, 0, 0}));
}

TEST(ReactionRun, EndsWithTheCauseWhereNoMixtureIs) {
  ScratchDirectory const scratch;
  auto const done = ran(scratch.path(), "run", {"fluid.rho=600 kg/m^3", "reaction.progress=0.9"});
  EXPECT_EQ(done.status, 3) << done.errors;
  EXPECT_NE(done.errors.find("mixture of progress"), std::string::npos) << done.errors;
}

} // namespace
} // namespace mesobridge::workflows
