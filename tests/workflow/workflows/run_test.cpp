#include "unit/workflows/scratch_directory.hpp"
#include "workflows/process.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

// `mesobridge run` as its users run it: the same bytes on any number of threads, interruption, restart,
// failure.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

std::vector<std::string> run_words(std::filesystem::path const& directory,
                                   std::vector<std::string> const& more) {
  std::vector<std::string> words{
      MESOBRIDGE_PROGRAM, "run",    MESOBRIDGE_SOURCE_DIR "/workflows/scenes/argon-1000K.toml", "-o",
      directory.string(), "--quiet"};
  for (char const* set : {"particles.K=20", "run.equilibrate=64", "run.steps=400", "run.sample_every=5",
                          "run.trajectory_every=100", "run.vtkhdf_every=80", "run.xyz_every=200",
                          "run.instant_every=25", "run.checkpoint_every=150"})
    words.insert(words.end(), {"--set", set});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

ProcessResult run(std::filesystem::path const& directory, std::vector<std::string> const& more = {}) {
  return run_process(run_words(directory, more));
}

/// All results of a run, but for the provenance, which names the command.
struct Files {
  std::vector<double> thermodynamics, moments, eps, positions, points;
  std::string xyz, summary, scene;
  friend bool operator==(Files const&, Files const&) = default;
};

Files files(std::filesystem::path const& directory) {
  Store const results(directory / "run.h5", Store::Mode::read),
      trajectory(directory / "trajectory.h5", Store::Mode::read),
      vtkhdf(directory / "trajectory.vtkhdf", Store::Mode::read);
  return {results.read_doubles("thermodynamics"),     results.read_doubles("moments"),
          results.read_doubles("particles/eps"),      trajectory.read_doubles("particles/all/position/value"),
          vtkhdf.read_doubles("VTKHDF/Points"),       read_text_file(directory / "trajectory.xyz"),
          read_text_file(directory / "summary.json"), read_text_file(directory / "scene.toml")};
}

TEST(Run, WritesTheSameBytesOnOneAndTwoThreads) {
  ScratchDirectory const scratch;
  auto const one = run(scratch / "one", {"--threads", "1"}), two = run(scratch / "two", {"--threads", "2"});
  ASSERT_EQ(one.status, 0) << one.errors;
  ASSERT_EQ(two.status, 0) << two.errors;
  auto const results = files(scratch / "one");
  EXPECT_EQ(results.thermodynamics.size(), 81u * 12u);
  EXPECT_EQ(results.positions.size(), 5u * 1000u * 3u);
  EXPECT_EQ(results.points.size(), 6u * 1000u * 3u);
  EXPECT_EQ(results.eps.size(), 17u * 1000u); // an instant every 25 steps
  EXPECT_EQ(std::count(results.xyz.begin(), results.xyz.end(), '\n'), 3 * 1002);
  EXPECT_TRUE(results == files(scratch / "two"));
  auto const other = run(scratch / "other", {"--seed", "2"});
  ASSERT_EQ(other.status, 0) << other.errors;
  EXPECT_FALSE(results.thermodynamics == files(scratch / "other").thermodynamics);
}

/// Starts a run, sends it SIGINT once its first checkpoint is there, and returns its exit code.
int interrupted_run(std::filesystem::path const& directory, std::vector<std::string> const& more = {}) {
  auto words = run_words(directory, more);
  std::vector<char*> argv;
  for (auto& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t const child = fork();
  if (child == 0) {
    execv(argv[0], argv.data());
    _exit(127);
  }
  auto const give_up = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (!std::filesystem::exists(directory / "checkpoint.h5") && std::chrono::steady_clock::now() < give_up)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(Run, GoesOnAfterAnInterruptionAsIfThereHadBeenNone) {
  ScratchDirectory const scratch;
  ASSERT_EQ(run(scratch / "unbroken").status, 0);
  ASSERT_EQ(interrupted_run(scratch / "broken"), 130);
  auto const stopped_at = read_checkpoint(scratch / "broken" / "checkpoint.h5").checkpoint.step;
  EXPECT_GT(stopped_at, 64u);
  EXPECT_LT(stopped_at, 464u); // it was stopped on the way
  {
    Store const results(scratch / "broken" / "run.h5", Store::Mode::read);
    EXPECT_GE(results.read_doubles("thermodynamics").size() / 12, 30u); // nothing that was written is lost
  }
  auto const resumed = run(scratch / "broken", {"--resume"});
  ASSERT_EQ(resumed.status, 0) << resumed.errors;
  EXPECT_TRUE(files(scratch / "unbroken") == files(scratch / "broken"));
}

TEST(Run, CalibratesItsDensitiesOnceAndGoesOnWithTheSameConstants) {
  ScratchDirectory const scratch;
  std::vector<std::string> const calibrated{"--set", "particles.density=calibrated",
                                            "--set", "particles.calibration_steps=200",
                                            "--set", "particles.N=512"};
  ASSERT_EQ(run(scratch / "unbroken", calibrated).status, 0);
  ASSERT_EQ(interrupted_run(scratch / "broken", calibrated), 130);
  auto resume = calibrated;
  resume.push_back("--resume");
  auto const resumed = run(scratch / "broken", resume);
  ASSERT_EQ(resumed.status, 0) << resumed.errors;
  EXPECT_TRUE(files(scratch / "unbroken") == files(scratch / "broken"));

  auto const summary = Json::parse(read_text_file(scratch / "unbroken" / "summary.json"));
  auto const found = summary["density_calibration"];
  EXPECT_EQ(summary["density_scale"], found["density_scale"]);
  EXPECT_GT(found["density_scale"].get<double>(), 1.005); // plain densities are not right at this size
  EXPECT_GT(found["density_self_se"].get<double>(), 0);
  // The resolved scene holds the constants: it needs no calibration to be the same run.
  auto const scene = (scratch / "unbroken" / "scene.toml").string();
  auto const again =
      run_process({MESOBRIDGE_PROGRAM, "run", scene, "-o", (scratch / "again").string(), "--quiet"});
  ASSERT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(files(scratch / "again").thermodynamics, files(scratch / "unbroken").thermodynamics);
  EXPECT_EQ(files(scratch / "again").scene, files(scratch / "unbroken").scene);
}

TEST(Run, RefusesToResumeAnotherScene) {
  ScratchDirectory const scratch;
  ASSERT_EQ(run(scratch / "a").status, 0);
  auto const other = run(scratch / "a", {"--resume", "--set", "fluid.T=900 K"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.errors.find("another scene"), std::string::npos) << other.errors;
  auto const none = run(scratch / "empty", {"--resume"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.errors.find("checkpoint.h5"), std::string::npos) << none.errors;
}

TEST(Run, SaysWhyItCannotGoOn) {
  ScratchDirectory const scratch;
  struct Case {
    std::vector<std::string> more;
    int code;
    std::string message;
  };
  std::vector<Case> const cases{
      {{"--set", "scheme.dt=2.0"}, 3, "particle "},    // far beyond Verlet's limit
      {{"--set", "particles.N=64"}, 2, "particles.N"}, // too few for the kernel
      {{"--set", "particles.N=997"}, 2, "three similar factors"},
      {{"--set", "fluid.eos=no-such-model.toml"}, 2, "no-such-model.toml"},
      {{"--set", "transport.zeta=1 Pa*s"}, 2, "zeta"},
      {{"--set", "run.steps=20"}, 2, "run.steps"},
      {{"--set", "particles.K=1"}, 2, "heat capacity 0.2"},
      {{"--set", "particles.density=given"}, 2, "both density_scale and density_self"},
      {{"--set", "particles.density_scale=1.1"}, 2, "allowed with density = "},
      // Liquid argon at its boiling point, nearly without pressure.
      {{"--set", "particles.density=calibrated", "--set", "fluid.T=87 K", "--set", "fluid.rho=1400 kg/m^3",
        "--set", "scheme.dt=0.01"},
       2,
       "response to compression"},
  };
  int ran = 0;
  for (auto const& [more, code, message] : cases) {
    auto const result = run(scratch / "x", more);
    EXPECT_EQ(result.status, code) << result.errors;
    EXPECT_NE(result.errors.find(message), std::string::npos) << result.errors;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    ++ran;
  }
  EXPECT_EQ(ran, 10);
}

TEST(BenchEngine, ReportsItsKeys) {
  auto const result =
      run_process({MESOBRIDGE_PROGRAM, "bench", "engine", "--side", "8", "--steps", "2", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  for (char const* key : {"us_per_particle_step", "neighbours", "threads", "scheme", "eos", "n"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_GT(json["us_per_particle_step"].get<double>(), 0);
  EXPECT_EQ(json["n"], 512);
}

} // namespace
} // namespace mesobridge::workflows
