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

/// While it lasts a folder is the one that we are in.
struct Inside {
  explicit Inside(fs::path const& folder) { fs::current_path(folder); }
  ~Inside() { fs::current_path(before); }
  fs::path before = fs::current_path();
};

/// All of the session's atoms after commands, of which `plugin load` is none.
md::Frame frame_after(fs::path const& folder, std::string const& commands) {
  md::MpiWorld const world;
  md::LammpsSession session(world, md::Ranks::own, folder / "log.lammps");
  sdpd::register_fluid_styles(session);
  Inside const inside(folder);
  std::istringstream lines(commands);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && !line.starts_with("plugin "))
      session.command(line);
  return session.frame();
}
md::Frame frame_after(fs::path const& folder) {
  return frame_after(folder, read_text_file(folder / "in.fluid"));
}

std::string replaced(std::string text, std::string const& from, std::string const& to) {
  auto const at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
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
  constexpr int before = 64, after = 20;
  Words const dpde{"particles.N=512", "scheme.name=ser", "scheme.dt=0.005", "run.equilibrate=16",
                   "run.sample_every=2"},
      sdpd{"particles.N=1000", "scheme.name=ems", "particles.density=plain", "run.equilibrate=16",
           "run.sample_every=2"},
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

/// A run of a DPDE fluid, and what LAMMPS goes on with.
void write_dpde(ScratchDirectory const& scratch) {
  auto const run = tests::program(run_words(
      "dpde-fluid",
      {"particles.N=512", "scheme.name=ssa", "scheme.dt=0.005", "run.equilibrate=16", "run.sample_every=2"},
      64, scratch / "run"));
  ASSERT_EQ(run.status, 0) << run.errors;
  auto const written = tests::program(
      {"lammps-plugin", (scratch / "run").string(), "--steps", "20", "-o", (scratch / "lammps").string()});
  ASSERT_EQ(written.status, 0) << written.errors;
}

/// Restart files hold the energies as they are, whatever the fix is called that takes them.
TEST_F(LammpsPlugin, GoesOnFromLammpssRestartFiles) {
  ScratchDirectory const scratch;
  write_dpde(scratch);
  auto const input = read_text_file(scratch / "lammps" / "in.fluid");
  auto const whole =
      frame_after(scratch / "lammps", replaced(input, "\nrun 20", "\nrun 20\nwrite_restart at.20\nrun 5"));
  int compared = 0;
  for (std::string const id : {"fluid", "liquid"}) {
    auto text = replaced(input, "read_data particles.data fix given NULL Energies", "read_restart at.20");
    text = replaced(text, "reset_timestep", "# reset_timestep");
    text = replaced(text, "\nrun 20", "\nrun 5");
    // Only what LAMMPS keeps is not said twice.
    for (std::size_t at = 0; (at = text.find("fluid all", at)) != text.npos; at += id.size())
      text.replace(at, 5, id);
    for (std::size_t at = 0; (at = text.find("f_fluid", at)) != text.npos; at += id.size())
      text.replace(at, 7, "f_" + id);
    text = replaced(text, "fix given all property/atom d_mesobridge_eps d_mesobridge_T\n", "");
    text = replaced(text, "read_restart at.20",
                    "read_restart at.20\nfix given all property/atom d_mesobridge_eps d_mesobridge_T");
    auto const rest = frame_after(scratch / "lammps", text);
    EXPECT_EQ(rest.step, whole.step);
    double p = 0;
    for (std::size_t k = 0; k < whole.velocities.size(); ++k)
      p = std::max(p, norm(rest.velocities[k] - whole.velocities[k]));
    EXPECT_LT(p, 1e-9) << id;
    ++compared;
  }
  EXPECT_EQ(compared, 2);
}

TEST_F(LammpsPlugin, TellsWhatAnInputHasWrong) {
  ScratchDirectory const scratch;
  write_dpde(scratch);
  auto const input = read_text_file(scratch / "lammps" / "in.fluid");
  struct Wrong {
    std::string from, to, message;
  };
  std::vector<Wrong> const all{
      {"pair_style mesobridge fluid.toml", "pair_style mesobridge", "needs the file of a fluid's scene"},
      {"pair_style mesobridge fluid.toml", "pair_style mesobridge none.toml", "none.toml"},
      {"pair_coeff * *", "pair_coeff * *\npair_style mesobridge fluid.toml", "has its fluid already"},
      {"fix fluid all mesobridge", "fix fluid all mesobridge word", "takes no words"},
      {"timestep 0.005", "timestep 0.01", "must be that of the fluid's scene, 0.005"},
      {"reset_timestep", "change_box all x final 0 30\nreset_timestep", "the box must be that"},
      {"\nrun 20", "\nundump particles\nthermo_style custom step\nunfix fluid\nrun 20",
       "needs `fix ID all mesobridge`"}};
  std::size_t told = 0;
  for (auto const& [from, to, message] : all) {
    try {
      frame_after(scratch / "lammps", replaced(input, from, to));
      ADD_FAILURE() << to;
    } catch (md::LammpsError const& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
    ++told;
  }
  EXPECT_EQ(told, all.size());
}

TEST_F(LammpsPlugin, RefusesByNameWhatItCannotRun) {
  ScratchDirectory const scratch;
  auto const folder = (scratch / "a").string(), scene = (scratch / "run").string();
  std::string const walls = MESOBRIDGE_SOURCE_DIR "/workflows/scenes/couette.toml";
  ASSERT_EQ(tests::program({"run", walls, "-o", scene, "--quiet", "--no-report", "--set", "run.steps=192",
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
