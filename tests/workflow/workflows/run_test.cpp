#include "scratch_directory.hpp"
#include "unit/workflows/killed_process.hpp"
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
  for (char const* set :
       {"particles.K=20", "particles.density=plain", "run.equilibrate=64", "run.steps=400",
        "run.sample_every=5", "run.trajectory_every=100", "run.vtkhdf_every=80", "run.xyz_every=200",
        "run.instant_every=25", "run.checkpoint_every=150", "profile.every=80", "histogram.every=100"})
    words.insert(words.end(), {"--set", set});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

ProcessResult run(std::filesystem::path const& directory, std::vector<std::string> const& more = {}) {
  return run_process(run_words(directory, more));
}

/// All results of a run, but for the provenance, which names the command.
struct Files {
  std::vector<double> thermodynamics, moments, eps, velocities, counts, positions, points;
  std::string xyz, summary, scene;
  friend bool operator==(Files const&, Files const&) = default;
};

Files files(std::filesystem::path const& directory) {
  Store const results(directory / "run.h5", Store::Mode::read),
      trajectory(directory / "trajectory.h5md", Store::Mode::read),
      vtkhdf(directory / "trajectory.vtkhdf", Store::Mode::read);
  return {results.read_doubles("thermodynamics"),
          results.read_doubles("moments"),
          results.read_doubles("particles/eps"),
          results.read_doubles("profile/velocity_m_s"),
          results.read_doubles("histogram/eps_J/counts"),
          trajectory.read_doubles("particles/trajectory/position/value"),
          vtkhdf.read_doubles("VTKHDF/Points"),
          read_text_file(directory / "trajectory.xyz"),
          read_text_file(directory / "summary.json"),
          read_text_file(directory / "scene.toml")};
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
  auto const until_checkpoint = [&] {
    auto const give_up = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (!std::filesystem::exists(directory / "checkpoint.h5") &&
           std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  };
  int const status = tests::killed(until_checkpoint, SIGINT, run_words(directory, more));
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

std::vector<double> column(Store const& store, std::string const& dataset, std::size_t width,
                           std::size_t which) {
  auto const all = store.read_doubles(dataset);
  std::vector<double> values;
  for (std::size_t k = which; k < all.size(); k += width)
    values.push_back(all[k]);
  return values;
}

// Profiles and histograms against the samples of the same steps, which are sums of their own.
TEST(Run, WritesProfilesAndHistogramsThatAddUpToTheWhole) {
  ScratchDirectory const scratch;
  ASSERT_EQ(run(scratch / "a", {"--set", "profile.axis=y", "--set", "profile.bins=7"}).status, 0);
  Store const store(scratch / "a" / "run.h5", Store::Mode::read);
  EXPECT_EQ(store.read_text_attribute("profile", "axis"), "y");
  EXPECT_EQ(store.shape("profile/velocity_m_s"), (Store::Shape{6, 7, 3}));
  EXPECT_EQ(store.read_doubles("profile/position_m").size(), 7u);
  auto const steps = store.read_integers("profile/step");
  EXPECT_EQ(steps, (std::vector<std::int64_t>{0, 80, 160, 240, 320, 400}));
  auto const number = store.read_doubles("profile/number");
  constexpr std::size_t columns = 12, samples_between = 16;
  auto const time = column(store, "thermodynamics", columns, 1),
             T = column(store, "thermodynamics", columns, 6),
             rho = column(store, "thermodynamics", columns, 8);
  auto const slices_T = store.read_doubles("profile/T_int_K"),
             slices_rho = store.read_doubles("profile/rho_kg_m3");
  int compared = 0;
  for (std::size_t k = 0; k < steps.size(); ++k, ++compared) {
    double count = 0, sum_T = 0, sum_rho = 0;
    for (std::size_t s = 7 * k; s < 7 * (k + 1); ++s)
      count += number[s], sum_T += number[s] * slices_T[s], sum_rho += number[s] * slices_rho[s];
    EXPECT_EQ(count, 1000);
    EXPECT_NEAR(sum_T / count / T[samples_between * k], 1, 1e-12);
    EXPECT_NEAR(sum_rho / count / rho[samples_between * k], 1, 1e-12);
    EXPECT_EQ(store.read_doubles("profile/time_s")[k], time[samples_between * k]);
  }
  EXPECT_EQ(compared, 6);

  ASSERT_EQ(store.shape("histogram/T_K/counts"), (Store::Shape{5, 50}));
  auto const counts = store.read_doubles("histogram/T_K/counts"),
             edges = store.read_doubles("histogram/T_K/edges");
  double mean = 0, all = 0;
  for (std::size_t b = 0; b < 50; ++b)
    all += counts[b], mean += counts[b] * 0.5 * (edges[b] + edges[b + 1]);
  EXPECT_EQ(all + store.read_doubles("histogram/T_K/below")[0] + store.read_doubles("histogram/T_K/above")[0],
            1000);
  EXPECT_NEAR(mean / all, T[0], edges[1] - edges[0]);
}

TEST(Run, TakesTheDiskThatCheckForetold) {
  ScratchDirectory const scratch;
  std::vector<std::string> const long_run{"--set", "run.steps=2000", "--set", "particles.N=512"};
  ASSERT_EQ(run(scratch / "a", long_run).status, 0);
  auto words = run_words(scratch / "a", long_run);
  words[1] = "check", words.insert(words.begin() + 2, "--json");
  auto const check = run_process(words);
  ASSERT_EQ(check.status, 0) << check.errors;
  double taken = 0;
  for (char const* name :
       {"run.h5", "trajectory.h5md", "trajectory.vtkhdf", "trajectory.xyz", "checkpoint.h5"})
    taken += static_cast<double>(std::filesystem::file_size(scratch / "a" / name));
  EXPECT_NEAR(Json::parse(check.output)["estimated_disk_bytes"].get<double>() / taken, 1, 0.1);
}

TEST(Run, RefusesToResumeAnotherScene) {
  ScratchDirectory const scratch;
  ASSERT_EQ(run(scratch / "a").status, 0);
  auto const before = files(scratch / "a");
  std::vector<std::string> const others{"fluid.T=900 K",
                                        "fluid.eos=ideal-gas",
                                        "particles.K=21",
                                        "particles.N=1331",
                                        "transport.eta=1e-3 Pa*s",
                                        "scheme.dt=0.02",
                                        "scheme.name=ems",
                                        "run.equilibrate=65",
                                        "run.sample_every=10",
                                        "run.instant_every=20",
                                        "run.seed=2",
                                        "particles.kernel=wendland-c2",
                                        "profile.bins=21",
                                        "histogram.reach=7",
                                        "run.thermostat=langevin"};
  int refused = 0;
  for (auto const& other : others) {
    auto more = std::vector<std::string>{"--resume", "--set", other};
    if (other == "fluid.eos=ideal-gas")
      more.insert(more.end(), {"--set", "fluid.m0=1e-25 kg"});
    auto const result = run(scratch / "a", more);
    EXPECT_EQ(result.status, 2) << other;
    EXPECT_NE(result.errors.find("another scene"), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find(other.substr(0, other.find('=')) + " was "), std::string::npos)
        << result.errors;
    ++refused;
  }
  EXPECT_EQ(refused, 15);
  EXPECT_TRUE(before == files(scratch / "a"));
}

TEST(Run, ExtendedIsThatOfMoreStepsFromTheStart) {
  ScratchDirectory const scratch;
  std::vector<std::string> const plain{"--set", "particles.density=plain"}; // whatever the steps
  auto with = [&](std::vector<std::string> const& more) {
    auto words = plain;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  ASSERT_EQ(run(scratch / "long", with({"--set", "run.steps=800"})).status, 0);
  ASSERT_EQ(run(scratch / "a", plain).status, 0);
  EXPECT_FALSE(files(scratch / "a") == files(scratch / "long"));
  // By 83 steps, at none of whose ends anything is due, and by the rest.
  for (char const* steps : {"run.steps=483", "run.steps=800"}) {
    auto const extended = run(scratch / "a", with({"--resume", "--set", steps}));
    ASSERT_EQ(extended.status, 0) << extended.errors;
  }
  EXPECT_TRUE(files(scratch / "a") == files(scratch / "long"));
}

// The checkpoints' schedule is none of the results'.
TEST(Run, HasTheSameBitsWhenItsCheckpointsAreWritten) {
  ScratchDirectory const scratch;
  auto of = [&](std::string const& name, std::vector<std::string> const& more) {
    EXPECT_EQ(run(scratch / name, more).status, 0);
    auto results = files(scratch / name);
    results.scene.clear();
    return results;
  };
  auto const seldom = of("seldom", {}), always = of("always", {"--set", "run.checkpoint_minutes=1e-9"}),
             never = of("never", {"--set", "run.checkpoint_minutes=0", "--set", "run.checkpoint_every=0"}),
             odd = of("odd", {"--set", "run.checkpoint_every=7"});
  EXPECT_TRUE(seldom == always);
  EXPECT_TRUE(seldom == never);
  EXPECT_TRUE(seldom == odd);
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

// EMS refuses the bad steps of pairs, not those of Verlet's motion. Which shows first where densities are
// calibrated.
TEST(Run, EndsWhenTheMotionRunsAway) {
  ScratchDirectory const scratch;
  for (std::string const density : {"plain", "auto"}) {
    std::vector<std::string> words{MESOBRIDGE_PROGRAM, "run",
                                   MESOBRIDGE_SOURCE_DIR "/workflows/scenes/ideal-gas.toml"};
    for (std::string const& set :
         {std::string("particles.K=5"), std::string("particles.N=343"), std::string("scheme.name=ems"),
          std::string("scheme.dt=0.8"), std::string("run.steps=640"), std::string("run.equilibrate=64"),
          std::string("run.sample_every=20"), "particles.density=" + density})
      words.insert(words.end(), {"--set", set});
    words.insert(words.end(), {"-o", (scratch / density).string(), "--quiet"});
    auto const result = run_process(words);
    EXPECT_EQ(result.status, 3) << result.errors;
    for (char const* part : {"step ", "kinetic temperature", "shorter time step"})
      EXPECT_NE(result.errors.find(part), std::string::npos) << part << ": " << result.errors;
  }
}

} // namespace
} // namespace mesobridge::workflows
