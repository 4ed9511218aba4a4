#include "error_text.hpp"
#include "fitting/shock_relations.hpp"
#include "piston_text.hpp"
#include "scratch_directory.hpp"
#include "sdpd/setup/balance.hpp"
#include "sdpd/setup/trial.hpp"
#include "workflows/reproduce/exact_cases.hpp"
#include "workflows/scene/tolerance.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/study/automatic_dt.hpp"
#include "workflows/study/driven_dt.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

/// A piston's scene with dt = "auto".
std::string piston_text(std::string const& eos, double v_P, std::string const& drift,
                        std::string const& more = "") {
  return tests::piston_text({.eos = eos,
                             .K = 50,
                             .v_P = v_P,
                             .length = 30,
                             .scheme = fmt::format("dt = \"auto\"\ndrift = \"{}\"\n{}", drift, more),
                             .run = "equilibrate = 50\nsteps = 56\nsample_every = 1"});
}

/// The same with a time step that is given.
std::string with_dt(std::string text, double dt) {
  auto const begin = text.find("dt = \"auto\""), end = text.find("[run]");
  return text.replace(begin, end - begin, fmt::format("dt = {}\n", dt));
}

/// The same between walls at rest.
std::string at_rest(std::string text) {
  auto const begin = text.find("piston = ");
  return text.erase(begin, text.find('\n', begin) - begin);
}

Scene scene_of(std::string const& text) {
  return parse_scene(text, "scene.toml");
}

std::string error_of(std::string const& text, std::vector<std::string> const& overrides = {}) {
  return tests::error_text<InputError>([&] { parse_scene(text, "scene.toml", overrides); });
}

/// The share of energy that the whole run misses with its time step.
double share_of_run(Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  auto const start = sdpd::equilibrated_start(settings, std::min(0.03, settings.dt),
                                              scene.run.equilibrate > 0 ? 5 : 0, [] { return true; });
  auto const found =
      sdpd::run_balance_trial({.settings = settings, .steps = scene.run.steps, .run_steps = scene.run.steps},
                              start, [](std::int64_t) { return true; });
  EXPECT_EQ(found.failure, "");
  EXPECT_GT(found.share, 0);
  return found.share;
}

TEST(DrivenTimeStep, IsForABalanceThatOnlySomethingDrivenHas) {
  auto const good = piston_text("argon", 500, "1 %");
  EXPECT_EQ(balance_tolerance(scene_of(good).scheme), 0.01);
  EXPECT_EQ(balance_tolerance(scene_of(piston_text("argon", 500, "1e-6/ps")).scheme), std::nullopt);
  EXPECT_NE(error_of(good, {"scheme.energy=kept"}).find("balances at any time step"), std::string::npos);
  EXPECT_NE(error_of(piston_text("argon", 500, "-1 %")).find("share > 0"), std::string::npos);
  EXPECT_NE(error_of(at_rest(good)).find("for scenes that something drives"), std::string::npos);
}

/// A table of the piston's velocities counts by its fastest one, also where that does not last.
TEST(DrivenTimeStep, BeginsWithOneForTheFastestMotionOfATable) {
  auto const constant = piston_text("argon", 2000, "1 %");
  auto const by_table = [&](std::string const& velocities) {
    auto text = constant;
    auto const begin = text.find("piston = ");
    return text.replace(begin, text.find('\n', begin) - begin,
                        "piston_times = [\"0 s\", \"1 ps\", \"2 ps\"]\npiston_velocities = [" + velocities +
                            "]");
  };
  double const dt = largest_driven_dt(scene_of(constant));
  EXPECT_LT(dt, 0.8 * largest_driven_dt(scene_of(piston_text("argon", 500, "1 %"))));
  EXPECT_DOUBLE_EQ(largest_driven_dt(scene_of(by_table("\"0 m/s\", \"1 km/s\", \"2 km/s\""))), dt);
  EXPECT_DOUBLE_EQ(largest_driven_dt(scene_of(by_table("\"0 m/s\", \"2 km/s\", \"0 m/s\""))), dt);
}

/// From pistons that hardly move to ones far faster than sound: in dense argon, and in a gas, in which sound
/// takes 339 m/s and their shocks 10.3 and 13.3 km/s, Mach 30 and 39.
TEST(DrivenTimeStep, BalancesTheEnergyBeforePistonsOfAnyVelocity) {
  int cases = 0;
  double before = 1;
  for (auto const& [eos, v_P] : {std::pair("argon", 50.0),
                                 {"argon", 500.0},
                                 {"argon", 2000.0},
                                 {"ideal-gas", 7700.0},
                                 {"ideal-gas", 10000.0}}) {
    auto const scene = scene_of(piston_text(eos, v_P, "1 %"));
    auto const chosen = choose_time_step(scene, {});
    EXPECT_EQ(chosen.scene.scheme.dt_chosen_for, "drift 1 %");
    EXPECT_LE(chosen.scene.scheme.dt.value, largest_driven_dt(scene));
    EXPECT_LE(share_of_run(chosen.scene), 0.013) << eos << " " << v_P; // another history, a noisy error
    bool const faster = eos == std::string("argon") && v_P > 50;       // than in the case before
    EXPECT_TRUE(!faster || chosen.scene.scheme.dt.value < before);
    before = chosen.scene.scheme.dt.value;
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

/// Without noise: a near vacuum behind two rarefactions, and two streams that collide.
TEST(DrivenTimeStep, BalancesTubes) {
  int cases = 0;
  for (auto const& tube : tube_cases()) {
    if (tube.name != "double-rarefaction" && tube.name != "noh")
      continue;
    auto scene = tube_scene(tube, 60);
    scene.scheme.dt = {.automatic = true}, scene.scheme.drift = "0.5 %";
    auto const chosen = choose_time_step(scene, {});
    EXPECT_LE(share_of_run(chosen.scene), 0.005) << tube.name; // the same history as the trial's
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

TEST(DrivenTimeStep, GoesOnWhereItWasStopped) {
  tests::ScratchDirectory const scratch;
  auto const scene = scene_of(piston_text("ideal-gas", 3000, "0.3 %"));
  int asked = 0;
  StudyOptions options{.directory = scratch.path()};
  auto const whole = choose_time_step(scene, options);
  options.keep_going = [&](double, std::string const&) { return ++asked, true; };
  EXPECT_EQ(choose_time_step(scene, options).scene, whole.scene);
  EXPECT_EQ(asked, 0); // all trials were stored
  EXPECT_EQ(choose_time_step(scene, {.threads = 2}).scene, whole.scene);
  auto const again = with_stored_time_step(scene, whole.scene);
  EXPECT_EQ(again, whole.scene);
}

TEST(DrivenTimeStep, SaysThatNoneKeepsTheTolerance) {
  auto const scene = scene_of(piston_text("ideal-gas", 3000, "0.0000001 %"));
  auto const error = tests::error_text<PhysicsError>([&] { choose_time_step(scene, {}); });
  EXPECT_NE(error.find("no time step of"), std::string::npos) << error;
  EXPECT_NE(error.find("0.0000001 %"), std::string::npos) << error;
}

TEST(DensityConstants, AreFoundBehindTheShockOfTheSameParticles) {
  auto const scene = parse_scene(with_dt(piston_text("ideal-gas", 1661, "1 %"), 0.045), "scene.toml",
                                 {"particles.density=calibrated-shocked"});
  auto const resting = settings_of(scene, 1), shocked = calibrated_settings(scene, 1);
  auto const exact = *piston_shock(resting, 1661);
  EXPECT_DOUBLE_EQ(shocked.rho, exact.behind.rho);
  EXPECT_DOUBLE_EQ(shocked.T, exact.behind.T);
  EXPECT_EQ(shocked.K(), resting.K());
  // The kernel and the time step are the same in metres and seconds.
  EXPECT_NEAR(shocked.range() * shocked.units().length() / (resting.range() * resting.units().length()), 1,
              1e-12);
  EXPECT_NEAR(shocked.dt * shocked.units().time() / (resting.dt * resting.units().time()), 1, 1e-12);
  EXPECT_GT(shocked.range(), 1.4 * resting.range());
  EXPECT_EQ(scale_condition_of(scene), sdpd::ScaleCondition::pressure);
  auto const still = at_rest(with_dt(piston_text("argon", 500, "1 %"), 0.02));
  EXPECT_NE(error_of(still, {"particles.density=calibrated-shocked"}).find("needs a piston"),
            std::string::npos);
}

} // namespace
} // namespace mesobridge::workflows
