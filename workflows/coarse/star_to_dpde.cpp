#include "workflows/coarse/star_to_dpde.hpp"
#include "md/error.hpp"
#include "md/held_blobs.hpp"
#include "md/star_piston.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// Words of a call, and options with their values.
struct Call {
  std::vector<std::string> words;

  template <class Value>
  Call& add(char const* option, Value const& value) {
    words.emplace_back(option);
    words.push_back(fmt::format("{}", value));
    return *this;
  }
};

/// What melts have in common, free or held.
Call melt_call(char const* command, md::StarMeltSettings const& s, std::filesystem::path const& folder) {
  Call call{{"md", command}};
  call.add("--star", s.star.name()).add("--molecules", s.molecules).add("--rho", s.rho).add("--T", s.T);
  call.add("--dt", s.dt).add("--equilibration-steps", s.equilibration_steps).add("--seed", s.seed);
  return call.add("--ranks", 1).add("-o", folder.string()); // two such runs at once lose nothing to waiting
}

std::int64_t frames_between(StarToDpdePlan const& plan) {
  double const every = plan.melt.dt * double(plan.melt.sample_every); // as often as the melt's
  return std::max<std::int64_t>(1, std::llround(every / plan.run_dt));
}

/// The fluid and its particles, as scenes begin.
std::string fluid_of_scene(StarToDpdePlan const& plan, double T, int N, char const* folder_of_model) {
  auto const& s = plan.melt;
  return fmt::format(R"(title = "{0} stars at rho = {1}, T = {2:.4g} as DPDE particles"
units = "lj"

[method]
name = "dpde"

[fluid]
rho = {1}
T = {2}

[particles]
N = {3}
model = "{4}/{0}-melt.toml" # mass, S(U), potential, friction and conduction, measured
)",
                     s.star.name(), s.rho, T, N, folder_of_model);
}

/// The scheme, and the head of the table of the run.
std::string scheme_of_scene(StarToDpdePlan const& plan, double dt) {
  bool const small = plan.melt.star.atoms() < 12; // whose energies come near the end of S(U) by chance
  return fmt::format(R"(
[scheme]
name = "{}"
conservative = "mclachlan"
dt = "{} tau"

[run]
)",
                     small ? "ems" : "ssa", dt);
}

md::StarPistonSettings piston_of(StarToDpdePlan const& plan, double T) {
  md::StarPistonSettings settings;
  settings.star = plan.melt.star, settings.rho = plan.melt.rho, settings.T = T;
  settings.v_P = plan.v_P.value(), settings.seed = plan.melt.seed;
  settings.across = plan.shock_across, settings.along = plan.shock_along;
  return settings;
}

/// A multiple of the steps between two frames.
std::int64_t run_steps(StarToDpdePlan const& plan) {
  auto const every = frames_between(plan);
  return every * std::max<std::int64_t>(1, std::llround(plan.run_time / (plan.run_dt * double(every))));
}

} // namespace

StarToDpdePlan star_to_dpde_plan(std::string const& preset, std::uint64_t seed) {
  StarToDpdePlan plan;
  auto& melt = plan.melt;
  melt.molecules = 216, melt.dt = 0.004, melt.sample_every = 25, melt.seed = seed;
  melt.sampling_steps = 75000;
  if (preset == "standard")
    plan.shock_across = 8, plan.shock_along = 100, melt.molecules = 512, melt.sampling_steps = 500000,
    plan.configurations = 12, plan.held_steps = 20000, plan.run_time = 4000;
  if (preset == "paper")
    plan.shock_across = 12, plan.shock_along = 160, melt.molecules = 1000, melt.dt = 0.002,
    melt.sample_every = 50, melt.sampling_steps = 2000000, plan.configurations = 24, plan.held_steps = 40000,
    plan.run_time = 10000;
  return plan;
}

void check(StarToDpdePlan const& plan) {
  md::check(plan.melt);
  md::HeldBlobsSettings held;
  static_cast<md::StarMeltSettings&>(held) = plan.melt;
  held.sample_every = md::HeldBlobsSettings().sample_every;
  held.sampling_steps = plan.held_steps, held.configurations = plan.configurations;
  md::check(held);
  require(plan.configurations >= 4, "configurations of held centres", plan.configurations,
          "must be at least 4 for standard errors");
  require(plan.run_time > 0 && std::isfinite(plan.run_time), "time of the coarse run", plan.run_time,
          "must be > 0");
  if (plan.v_P)
    md::check(piston_of(plan, plan.melt.T));
  double const side = std::cbrt(double(plan.melt.molecules));
  require(std::abs(side - std::round(side)) < 1e-9, "molecules", plan.melt.molecules,
          "must be a cube, such as 216 or 512: the coarse particles begin on a cubic lattice");
}

std::vector<Stage> model_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory) {
  auto const in = [&](char const* name) { return directory / name; };
  auto const text = [&](char const* name) { return (directory / name).string(); };
  auto const& s = plan.melt;
  auto const name = s.star.name();
  auto melt = melt_call("star-melt", s, in("melt"));
  melt.add("--sampling-steps", s.sampling_steps).add("--sample-every", s.sample_every);
  auto held = melt_call("held-blobs", s, in("held"));
  held.add("--sampling-steps", plan.held_steps).add("--configurations", plan.configurations);
  Call potential{{"cg", "potential", text("melt/blobs.h5"), "--pressure", "--seed", std::to_string(s.seed),
                  "-o", text("potential")}};
  if (plan.cutoff)
    potential.add("--cutoff", *plan.cutoff);
  return {
      {"melt of " + name + " stars, free and held",
       melt.words,
       in("melt/summary.json"),
       in("melt/star-melt.restart"),
       {},
       true},
      {"molecules held at their centres", held.words, in("held/summary.json"), in("held/held-blobs.restart")},
      {"motion of the molecules",
       {"cg", "transport", text("melt/blobs.h5"), "-o", text("melt")},
       in("melt/transport.json")},
      {"potential", potential.words, in("potential/potential.csv")},
      {"friction",
       {"cg", "friction", text("held/held.h5"), "--velocities", text("melt/transport.json"), "-o",
        text("friction")},
       in("friction/friction.csv")},
      {"exchange of energy",
       {"cg", "exchange", text("melt/blobs.h5"), "--friction", text("friction/friction.csv"), "-o",
        text("exchange")},
       in("exchange/conduction.csv")},
      {"model of a particle",
       {"fit", "dpde", text("melt/blobs.h5"), "--potential", text("potential/potential.csv"), "--friction",
        text("friction/friction.csv"), "--conduction", text("exchange/conduction.csv"), "-o", text("model")},
       in("model") / (name + "-melt.toml")},
  };
}

std::vector<Stage> run_stages(std::filesystem::path const& directory) {
  auto const in = [&](char const* name) { return directory / name; };
  auto const text = [&](char const* name) { return (directory / name).string(); };
  return {
      {"run of the particles",
       {"run", text("scene.toml"), "--threads", "1", "-o", text("run")},
       in("run/summary.json"),
       in("run/scene.toml"),
       {"--force"}},
      {"motion of the particles",
       {"cg", "transport", text("run"), "--beside", text("melt/transport.json")},
       in("run/transport.json")},
  };
}

std::vector<Stage> shock_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory,
                                double T) {
  auto const folder = directory / "shock";
  auto const settings = piston_of(plan, T);
  Call melt{{"md", "piston-shock", "--star", settings.star.name()}};
  melt.add("--rho0", settings.rho).add("--T0", fmt::format("{:.5g}", T)).add("--vp", settings.v_P);
  melt.add("--cells-across", settings.across)
      .add("--cells-along", settings.along)
      .add("--seed", settings.seed);
  melt.add("--ranks", 1).add("-o", (folder / "melt").string());
  return {
      {"piston in the melt and in the particles", melt.words, folder / "melt/summary.json", {}, {}, true},
      {"piston in the particles",
       {"run", (folder / "scene.toml").string(), "--threads", "1", "-o", (folder / "run").string()},
       folder / "run/summary.json",
       folder / "run/scene.toml",
       {"--force"}},
  };
}

std::string coarse_scene(StarToDpdePlan const& plan, double T) {
  auto const& s = plan.melt;
  double const spacing = std::cbrt(s.star.atoms() / s.rho);
  auto const side = std::llround(std::cbrt(double(s.molecules)));
  return fluid_of_scene(plan, T, s.molecules, "model") +
         fmt::format(R"(
[box]
lattice = [{0}, {0}, {0}]
)",
                     side) +
         scheme_of_scene(plan, plan.run_dt) +
         fmt::format(R"(equilibrate = {0}
steps = {1}
sample_every = {2}
trajectory_every = {2}
seed = {3}

[series]
every = {2}
quantities = ["internal_energy_spread"]
)",
                     std::llround(20 * spacing / plan.run_dt), run_steps(plan), frames_between(plan), s.seed);
}

std::string shock_scene(StarToDpdePlan const& plan, double T, double P) {
  auto const& s = plan.melt;
  double const spacing = std::cbrt(s.star.atoms() / s.rho), dt = plan.run_dt / 2, v_P = plan.v_P.value();
  // P goes about as rho^2, and a little longer a run does no harm.
  double const v_S = std::sqrt(2 * P / s.rho) + 0.8 * v_P;
  auto const steps = std::llround(plan.shock_along * spacing / v_S / dt);
  auto const every = std::max<std::int64_t>(1, std::llround(0.2 / dt));
  return fluid_of_scene(plan, T, plan.shock_across * plan.shock_across * plan.shock_along, "../model") +
         fmt::format(R"(
[box]
lattice = [{0}, {0}, {1}]
z = "walls" # mirrors; the lower one is the piston
piston = {2}
)",
                     plan.shock_across, plan.shock_along, v_P) +
         scheme_of_scene(plan, dt) +
         fmt::format(R"(equilibrate = {0}
steps = {1}
sample_every = {2}
seed = {3}

[profile]
axis = "z"
bins = {4}
every = {2}

[series]
every = {2}
quantities = ["wall_pressure", "wall_work"]
)",
                     std::llround(20 * spacing / plan.run_dt), steps, every, s.seed, plan.shock_along);
}

} // namespace mesobridge::workflows
