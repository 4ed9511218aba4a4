#include "cg/diffusion.hpp"
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_scene.hpp"
#include "workflows/scene/tolerance.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/study/automatic_dt.hpp"
#include "workflows/study/dynamics.hpp"
#include <gtest/gtest.h>
#include <iostream>
#include <limits>

// Does a longer run of another seed, in another box, keep what dt = "auto" was asked to keep?

namespace mesobridge::workflows {
namespace {

/// A scene without its scheme.
struct ScenePart {
  std::string name, text, scheme, drift;
  double time; ///< of the longer run, reduced

  friend void PrintTo(ScenePart const& part, std::ostream* out) { *out << part.name; }
};

std::string fluid_text(std::string const& fluid, std::string const& eos, int K) {
  return tests::SdpdScene{.fluid = "eos = \"" + eos + "\"\n" + fluid,
                          .N = 512,
                          .K = K,
                          .particles = "density = \"plain\"\n",
                          .scheme = "SCHEME",
                          .run = "equilibrate = 1000\nsteps = 10000\n"}
      .text();
}

std::vector<ScenePart> scene_parts() {
  std::string const gas = "rho = \"1150 kg/m^3\"\nT = \"1000 K\"\nm0 = \"1e-25 kg\"\n",
                    argon = "rho = \"1150 kg/m^3\"\nT = \"1000 K\"\n",
                    nitromethane = "rho = \"1104 kg/m^3\"\nT = \"300 K\"\n";
  std::string const soft =
      "title = \"soft\"\nunits = \"lj\"\n[method]\nname = \"dpde\"\n[fluid]\nrho = 3\nT = 1\n[particles]\nN "
      "= "
      "512\nmass = 1\n[potential]\nname = \"soft\"\na = 25\ncutoff = 1\n[friction]\ngamma_par = "
      "4.5\ngamma_perp = 2\ncutoff = 1\n[internal_energy]\nheat_capacity = "
      "60\n[scheme]\nSCHEME[run]\nequilibrate "
      "= 1000\nsteps = 10000\n";
  return {{"gas_10_ems", fluid_text(gas, "ideal-gas", 10), "name = \"ems\"\n", "1e-5/ps", 600},
          {"gas_100_ssa", fluid_text(gas, "ideal-gas", 100), "", "1e-6/ps", 800},
          {"argon_100_ssa", fluid_text(argon, "argon", 100), "", "1e-6/ps", 800},
          {"argon_1000_strang", fluid_text(argon, "argon", 1000), "splitting = \"strang\"\n", "1e-6/ps", 800},
          {"nitromethane_100_two_stage", fluid_text(nitromethane, "nitromethane", 100),
           "conservative = \"two-stage\"\n", "1e-6/ps", 800},
          {"soft_dpde", soft, "", "1e-5", 300}};
}

Scene scene_of(ScenePart const& part, std::string const& tolerance, int seed) {
  auto text = part.text;
  std::string const place = "SCHEME";
  text.replace(text.find(place), place.size(), "dt = \"auto\"\n" + part.scheme + tolerance);
  return parse_scene(text, part.name + ".toml", {"run.seed=" + std::to_string(seed)});
}

/// A run of its own, reduced.
struct LongRun {
  sdpd::Equilibrium means;
  cg::Estimate D;
};

LongRun long_run(Scene const& scene, double dt, double time, std::uint64_t seed) {
  auto settings = settings_of(scene, 1);
  settings.dt = dt, settings.seed = seed;
  sdpd::Simulation simulation(settings);
  sdpd::equilibrate(simulation, static_cast<std::uint64_t>(0.15 * time / dt), [] { return true; });
  sdpd::EquilibriumSampler sampler(settings.features());
  cg::BlobSeries series{.molecules = simulation.size(), .atoms = 1, .mass = 1, .free_atoms = true};
  auto const between = static_cast<std::uint64_t>(std::max(1.0, std::round(0.2 / dt)));
  auto const looks = static_cast<std::uint64_t>(time / (dt * double(between)));
  std::uint64_t const every = settings.features().densities ? 4 : 2; // soft particles go far between frames
  for (std::uint64_t look = 0; look <= looks; ++look) {
    if (look > 0)
      simulation.advance(between);
    double const now = double(look * between) * dt;
    sampler.sample(simulation.observe(), now);
    if (look % every != 0)
      continue;
    auto const shot = simulation.snapshot();
    sampler.sample(sdpd::moments(shot));
    series.times.push_back(now), series.boxes.push_back(simulation.box());
    series.R.insert(series.R.end(), shot.q.begin(), shot.q.end());
    series.P.insert(series.P.end(), shot.p.begin(), shot.p.end());
  }
  return {sampler.result(), cg::diffusion(series, {.longest = 16}).D};
}

/// Of what a longer run says against the tolerance.
struct Found {
  double value, se, wanted;
  double surely() const { return value - 2 * se; }
};

cg::Estimate ratio(cg::Estimate const& a, cg::Estimate const& b) {
  double const value = a.mean / b.mean;
  return {value, std::abs(value) * std::hypot(a.se / a.mean, b.se / b.mean), std::min(a.n_eff, b.n_eff)};
}

Found found_drift(ScenePart const& part, Scene const& scene, LongRun const& run) {
  double const time = settings_of(scene, 1).units().time();
  return {std::abs(run.means.drift.rate), run.means.drift.se, parse_rate(part.drift, scene.units) * time};
}

/// The worst of the temperatures, and of the pressure beside a run of shorter steps.
Found found_bias(LongRun const& run, LongRun const& shorter, double wanted) {
  Found worst{0, std::numeric_limits<double>::infinity(), wanted}; // any other is surely more
  for (auto const& one : {run.means.T_kin, run.means.T_int, ratio(run.means.P, shorter.means.P)})
    if (Found const now{std::abs(one.mean - 1), one.se, wanted}; now.surely() > worst.surely())
      worst = now;
  return worst;
}

Found found_dynamics(LongRun const& run, LongRun const& shorter, double wanted) {
  auto const D = ratio(run.D, shorter.D);
  return {std::abs(D.mean - 1), D.se, wanted};
}

class KeptTolerances : public ::testing::TestWithParam<std::tuple<ScenePart, std::string>> {};

TEST_P(KeptTolerances, InLongerRunsOfOtherSeeds) {
  constexpr double bias = 0.01, dynamics = 0.05;
  auto const& [part, name] = GetParam();
  std::map<std::string, std::string> const keys{{"drift", fmt::format("drift = \"{}\"\n", part.drift)},
                                                {"bias", "bias = \"1%\"\n"},
                                                {"dynamics", "dynamics = \"5%\"\n"}};
  for (int seed = 1; seed <= 3; ++seed) {
    auto const chosen = choose_time_step(scene_of(part, keys.at(name), seed), {}).scene;
    double const dt = settings_of(chosen, 1).dt;
    auto const other = static_cast<std::uint64_t>(100 + seed);
    auto const run = long_run(chosen, dt, part.time, other);
    Found found{};
    if (name == "drift")
      found = found_drift(part, chosen, run);
    else if (name == "bias")
      found = found_bias(run, long_run(chosen, dt / 4, part.time, other), bias);
    else
      found = found_dynamics(
          run, long_run(chosen, std::min(dt / 4, dt_by_bound(chosen, 0.0025)), part.time, other), dynamics);
    std::cout << fmt::format("{} {} seed {}: dt {:.3g}, {:.2f} +- {:.2f} of the tolerated\n", part.name, name,
                             seed, dt, found.value / found.wanted, found.se / found.wanted)
              << std::flush;
    EXPECT_LE(found.surely(), found.wanted) << part.name << " " << name << " " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Long_Scenes, KeptTolerances,
                         ::testing::Combine(::testing::ValuesIn(scene_parts()),
                                            ::testing::Values("drift", "bias", "dynamics")),
                         [](auto const& info) {
                           return std::get<0>(info.param).name + "_" + std::get<1>(info.param);
                         });

} // namespace
} // namespace mesobridge::workflows
