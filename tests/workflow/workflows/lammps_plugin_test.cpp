#include "program.hpp"
#include "refusals.hpp"
#include "scratch_directory.hpp"
#include "sdpd/lammps/fluid_styles.hpp"
#include "sdpd/lammps/styles.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sstream>

// `mesobridge lammps-plugin`: what it writes is run here by a LAMMPS that knows the styles.

extern "C" void lammpsplugin_init(void* lammps, void* handle, void* offer);

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words run_words(std::string const& scene, Words const& settings, int steps, fs::path const& directory) {
  Words words{"run",       MESOBRIDGE_SOURCE_DIR "/workflows/scenes/" + scene + ".toml",
              "--engine",  "lammps",
              "--ranks",   "1",
              "--threads", "1",
              "-o",        directory.string(),
              "--quiet",   "--no-report",
              "--resume"};
  for (auto const& set : settings)
    words.insert(words.end(), {"--set", set});
  words.insert(words.end(), {"--set", fmt::format("run.steps={}", steps)});
  return words;
}

/// All of the session's atoms after the commands of an input, but for `plugin load`.
md::Frame frame_after(fs::path const& folder) {
  md::MpiWorld const world;
  md::LammpsSession session(world, md::Ranks::own, folder / "log.lammps");
  sdpd::register_fluid_styles(session);
  auto const here = fs::current_path();
  fs::current_path(folder);
  std::istringstream lines(read_text_file(folder / "in.fluid"));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && !line.starts_with("plugin "))
      session.command(line);
  fs::current_path(here);
  return session.frame();
}

struct Offered {
  char const *version, *style, *name, *info, *author;
  void *make, *handle;
};
std::vector<std::string> offers;
void take_offer(Offered* of, void*) {
  offers.push_back(std::string(of->style) + " " + of->name);
}

class LammpsPlugin : public ::testing::Test {
 protected:
  void SetUp() override {
    offers.clear();
    lammpsplugin_init(nullptr, nullptr, reinterpret_cast<void*>(take_offer));
  }
};

TEST_F(LammpsPlugin, OffersBothStyles) {
  EXPECT_EQ(offers, (Words{"pair mesobridge", "fix mesobridge"}));
}

/// A LAMMPS that reads the input goes the way of the run itself.
TEST_F(LammpsPlugin, GoesOnWhereTheRunWas) {
  int compared = 0;
  constexpr int before = 32, after = 20;
  Words const dpde{"particles.N=512", "scheme.name=ser", "scheme.dt=0.005", "run.equilibrate=16",
                   "run.sample_every=2"},
      sdpd{"particles.N=1000", "scheme.name=ems", "particles.density=plain", "run.equilibrate=16",
           "run.sample_every=4"},
      dpd{"particles.N=512", "scheme.name=ssa", "run.equilibrate=16", "run.sample_every=2"};
  for (auto const& [scene, settings] :
       {std::pair("dpde-fluid", dpde), {"sdpd-ranks", sdpd}, {"dpd-fluid", dpd}}) {
    ScratchDirectory const scratch;
    auto const run = scratch / "run";
    auto const first = tests::program(run_words(scene, settings, before, run));
    ASSERT_EQ(first.status, 0) << first.errors;
    auto const written = tests::program({"lammps-plugin", run.string(), "--steps", std::to_string(after),
                                         "-o", (scratch / "with lammps").string()});
    ASSERT_EQ(written.status, 0) << written.errors;
    auto const frame = frame_after(scratch / "with lammps");
    EXPECT_EQ(frame.step, 16 + before + after);
    auto const second = tests::program(run_words(scene, settings, before + after, run));
    ASSERT_EQ(second.status, 0) << second.errors;
    auto const stored = read_checkpoint(run / "checkpoint.h5").checkpoint;
    ASSERT_EQ(stored.step, std::uint64_t(frame.step));
    ASSERT_EQ(frame.positions.size(), stored.particles.size());
    double q = 0, p = 0;
    for (std::size_t k = 0; k < stored.particles.size(); ++k) {
      auto const id = stored.particles.id[k];
      q = std::max(q, norm(frame.box.minimum_image(frame.positions[id] - stored.particles.q[k])));
      p = std::max(p, norm(frame.velocities[id] - stored.particles.p[k]));
    }
    EXPECT_LT(q, 1e-9) << scene;
    EXPECT_LT(p, 1e-9) << scene;
    auto const dump = read_text_file(scratch / "with lammps" / "README.md");
    EXPECT_NE(dump.find("MESOBRIDGE_LAMMPS_SOURCE"), std::string::npos);
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

TEST_F(LammpsPlugin, RefusesByNameWhatItCannotRun) {
  ScratchDirectory const scratch;
  auto const folder = (scratch / "a").string(), scene = (scratch / "run").string();
  std::string const walls = MESOBRIDGE_SOURCE_DIR "/workflows/scenes/couette.toml";
  ASSERT_EQ(tests::program({"run", walls, "-o", scene, "--quiet", "--no-report", "--set", "run.steps=4",
                            "--set", "run.equilibrate=4", "--set", "run.sample_every=2"})
                .status,
            0);
  std::vector<tests::Refusal> const cases{
      {{"lammps-plugin", scene, "-o", folder}, 2, "box"},
      {{"lammps-plugin", (scratch / "none").string(), "-o", folder}, 2, "RUN = "},
      {{"lammps-plugin", scene, "--steps", "0", "-o", folder}, 2, "--steps"}};
  EXPECT_EQ(tests::expect_refusals(cases), 3);
  EXPECT_FALSE(fs::exists(folder));
}

} // namespace
} // namespace mesobridge::workflows
