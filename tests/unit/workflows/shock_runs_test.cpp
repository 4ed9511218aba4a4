#include "scratch_directory.hpp"
#include "workflows/command_line.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/shock_study/shock_runs.hpp"
#include <gtest/gtest.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

namespace mesobridge::workflows {
namespace {

PistonScene small(std::string const& scheme, double dt, double K = 5) {
  return {.eos = "ideal-gas",
          .rho = 1150,
          .T = 1000,
          .v_P = 1661,
          .K = K,
          .eta = 2e-3,
          .dt = dt,
          .scheme = scheme,
          .lattice = {7, 7, 24},
          .equilibrate = 0,
          .seed = 1,
          .as_in_the_thesis = true};
}

using tests::ScratchDirectory;

Context quiet() {
  Context context;
  context.options.quiet = true;
  context.log = std::make_shared<spdlog::logger>("none", std::make_shared<spdlog::sinks::null_sink_mt>());
  return context;
}

TEST(PistonScene, RunsUntilTheFrontIsNearTheFarEnd) {
  auto wanted = small("ems", 0.02);
  wanted.lattice = {7, 7, 108};
  auto const scene = piston_scene(wanted);
  auto const settings = settings_of(scene, 1);
  // 2314.1 m/s by the relations of Rankine and Hugoniot; a ramp of 8 l/v_S costs half of itself.
  double const steps = (100 + 4) * settings.units().length() / 2314.1 / (0.02 * settings.units().time());
  EXPECT_NEAR(double(scene.run.steps), steps, 2);
  EXPECT_EQ(scene.particles.kernel, "cubic");
  EXPECT_EQ(scene.particles.density, "plain");
  wanted.as_in_the_thesis = false;
  EXPECT_EQ(piston_scene(wanted).particles.density, "auto");
  EXPECT_EQ(parse_scene(resolved_toml(scene), "scene.toml"), scene);
}

TEST(RunShocks, KeepsWhatARunHasShownAndWhyOneEnded) {
  ScratchDirectory const scratch;
  ReproduceOptions const options{.directory = scratch.path(), .seed = 1, .threads = 1};
  std::vector<ShockCase> const cases{{"ems", "EMS", piston_scene(small("ems", 0.03))},
                                     {"ssa", "SSA", piston_scene(small("ssa", 0.1, 2))}};
  auto const rows = run_shocks("two", cases, options, quiet());
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_TRUE(rows[0].failure.starts_with("no steady shock in the box within")) << rows[0].failure; // 24 long
  EXPECT_NE(rows[1].failure.find("particle"), std::string::npos) << rows[1].failure;
  EXPECT_NE(rows[1].failure.find("step"), std::string::npos) << rows[1].failure;
  EXPECT_EQ(rows[1].model, "SSA");
  auto const written = std::filesystem::last_write_time(scratch.path() / "runs/ems/run.h5");
  auto const again = run_shocks("two", cases, options, quiet());
  EXPECT_EQ(again[1].failure, rows[1].failure);
  EXPECT_EQ(std::filesystem::last_write_time(scratch.path() / "runs/ems/run.h5"), written);
}

} // namespace
} // namespace mesobridge::workflows
