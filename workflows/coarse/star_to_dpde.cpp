#include "workflows/coarse/star_to_dpde.hpp"
#include "fitting/particle_model_file.hpp"
#include "md/error.hpp"
#include "md/held_blobs.hpp"
#include "md/star_piston.hpp"
#include "workflows/call_words.hpp"
#include "workflows/provenance.hpp"
#include "workflows/text_file.hpp"
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <span>

namespace mesobridge::workflows {
namespace {

/// What melts have in common, free or held.
CallWords melt_call(char const* command, md::StarMeltSettings const& s, std::filesystem::path const& folder) {
  CallWords call{{"md", command}};
  call.add("--star", s.star.name()).add("--molecules", s.molecules).add("--rho", s.rho).add("--T", s.T);
  call.add("--dt", s.dt).add("--equilibration-steps", s.equilibration_steps).add("--seed", s.seed);
  return call.add("--ranks", 1).add("-o", folder.string()); // two such runs at once lose nothing to waiting
}

md::StarPistonSettings piston_of(StarToDpdePlan const& plan, double T) {
  md::StarPistonSettings settings;
  settings.star = plan.melt.star, settings.rho = plan.melt.rho, settings.T = T;
  settings.v_P = plan.v_P.value(), settings.seed = plan.melt.seed;
  settings.across = plan.shock_across, settings.along = plan.shock_along;
  return settings;
}

} // namespace

std::vector<double> usual_time_steps() {
  return {0.05, 0.1, 0.2};
}

StarToDpdePlan star_to_dpde_plan(std::string const& preset, std::uint64_t seed) {
  StarToDpdePlan plan;
  plan.runs = coarse_runs(usual_time_steps(), {});
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

double range_of(std::filesystem::path const& file) {
  auto const model = fitting::parse_particle_model(read_text_file(file), file.string());
  double range = 0;
  for (auto const* columns : {&model.potential, &model.friction})
    if (auto const r = columns->find("r"); r != columns->end() && !r->second.empty())
      range = std::max(range, r->second.back());
  return range;
}

std::vector<CoarseRun> coarse_runs(std::vector<double> const& time_steps,
                                   std::vector<std::filesystem::path> const& other_models) {
  require(!time_steps.empty(), "time steps of the coarse run", time_steps.size(), "must be one or several");
  std::vector<CoarseRun> runs{{.dt = time_steps.front()}};
  for (double const dt : std::span(time_steps).subspan(1))
    runs.push_back({.name = fmt::format("run-dt-{}", dt), .dt = dt});
  for (auto const& model : other_models) {
    double const range = range_of(model);
    auto const hash = sha256(read_text_file(model)).substr(0, 8);
    runs.push_back({.name = fmt::format("run-{}-{}", model.stem().string(), hash),
                    .dt = time_steps.front(),
                    .model = std::filesystem::absolute(model),
                    .range = range});
  }
  return runs;
}

std::int64_t steps_at(double rho, std::int64_t usual, std::int64_t every) {
  double const longer = std::clamp(std::pow(0.3 / rho, 1.5), 1.0, 10.0);
  return every * std::llround(double(usual) * longer / double(every));
}

std::int64_t sample_every_at(double rho, std::int64_t usual) {
  return rho > 0.4 ? std::min<std::int64_t>(usual, 10) : usual;
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
  std::set<std::string> names;
  for (auto const& run : plan.runs) {
    require(run.dt > 0 && run.dt <= plan.run_time, "time step of the coarse run", run.dt,
            fmt::format("must be > 0 and at most its time, {:g}", plan.run_time));
    require(names.insert(run.name).second, "run of the coarse fluid", run.name, "must be named once");
  }
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
  CallWords potential{{"cg", "potential", text("melt/blobs.h5"), "--pressure", "--seed",
                       std::to_string(s.seed), "-o", text("potential")}};
  potential.add("--cutoff", plan.cutoff);
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

std::vector<Stage> run_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory) {
  std::vector<Stage> stages;
  for (auto const& run : plan.runs) {
    auto const folder = directory / run.name;
    auto const which = run.name == "run" ? std::string() : " (" + run.name + ")";
    stages.push_back({"run of the particles" + which,
                      {"run", (directory / run.scene()).string(), "--threads", "1", "-o", folder.string()},
                      folder / "summary.json",
                      folder / "scene.toml",
                      {"--force"}});
    stages.push_back(
        {"motion of the particles" + which,
         {"cg", "transport", folder.string(), "--beside", (directory / "melt/transport.json").string()},
         folder / "transport.json"});
  }
  return stages;
}

int least_across(StarToDpdePlan const& plan, double range) {
  constexpr double skin = 0.4; // of the lists, in distances between molecules
  double const spacing = std::cbrt(plan.melt.star.atoms() / plan.melt.rho);
  return int(std::ceil(2 * (range / spacing + skin)));
}

std::vector<Stage> shock_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory,
                                double T) {
  auto const folder = directory / "shock";
  auto const settings = piston_of(plan, T);
  CallWords melt{{"md", "piston-shock", "--star", settings.star.name()}};
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

} // namespace mesobridge::workflows
