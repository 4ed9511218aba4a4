#include "workflows/shock_study/shock_runs.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/shock.hpp"
#include "workflows/study/driven_runs.hpp"
#include <algorithm>

namespace mesobridge::workflows {

template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, ShockRow>
void for_each_member(Result& r, F const& f) {
  f("model", r.model), f("K", r.K), f("eta", r.eta), f("dt", r.dt_reduced), f("spacing", r.spacing);
  f("particles", r.particles), f("v_S", r.v_S), f("rho", r.rho), f("mass_per_volume", r.mass_per_volume);
  f("P", r.P), f("T", r.T), f("T_kin", r.T_kin), f("depth", r.depth), f("profile", r.profile),
      f("profile_se", r.profile_se);
  f("failure", r.failure);
}

namespace {

constexpr double end_zone = 8;       ///< spacings before the far end at which the run may end
constexpr std::int64_t frames = 100; // about so many of a run

/// Steps until the front, whose piston was ramped over 8 l/v_S, has come near the far end.
std::int64_t steps_of(PistonScene const& wanted, Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  auto const shock = piston_shock(settings, wanted.v_P);
  auto const units = settings.units();
  double const v_S = shock->v_S / units.velocity(), ramp = 8 / v_S;
  double const way = static_cast<double>(wanted.lattice[2]) - end_zone;
  return static_cast<std::int64_t>((way / v_S + ramp / 2) / wanted.dt);
}

ShockRow row_of(ShockCase const& one, RunResult const& run, Store const& store) {
  auto const& settings = run.settings;
  ShockRow row{.model = one.model,
               .K = settings.K(),
               .eta = one.scene.transport.eta,
               .dt_reduced = settings.dt,
               .spacing = settings.spacing() * settings.units().length(),
               .particles = one.scene.particles.N};
  auto const shock = shock_of(store, run.scene, settings);
  if (!shock) {
    row.failure = fmt::format("no steady shock in the box within {} steps", run.scene.run.steps);
    return row;
  }
  row.v_S = shock->measured.v_S, row.rho = shock->measured.rho, row.P = shock->measured.P;
  row.T = shock->measured.T, row.T_kin = shock->T_kin, row.mass_per_volume = shock->mass_per_volume;
  row.depth = shock->depth;
  for (auto const& rho : shock->rho)
    row.profile.push_back(rho.mean), row.profile_se.push_back(rho.se);
  return row;
}

ShockRow failed(ShockCase const& one, std::string const& why) {
  return {.model = one.model,
          .K = one.scene.particles.K,
          .eta = one.scene.transport.eta,
          .dt_reduced = one.scene.scheme.dt.value,
          .particles = one.scene.particles.N,
          .failure = why};
}

} // namespace

Scene piston_scene(PistonScene const& wanted) {
  Scene scene;
  scene.title =
      fmt::format("{}, K = {:g}, eta = {:g} Pa s, {}", wanted.eos, wanted.K, wanted.eta, wanted.scheme);
  scene.fluid.eos = wanted.eos, scene.fluid.rho = wanted.rho, scene.fluid.T = wanted.T;
  scene.particles.K = wanted.K;
  scene.particles.N = wanted.lattice[0] * wanted.lattice[1] * wanted.lattice[2];
  if (wanted.eos == "ideal-gas")
    scene.fluid.m0 = 1e-25;
  scene.particles.density = wanted.density;
  if (wanted.as_in_the_thesis) {
    scene.particles.kernel = "cubic", scene.particles.density = "plain", scene.box.ramp = 0;
    if (wanted.eos != "ideal-gas") // whose particles the thesis gives 3/2 (K-1) k_B: free of their own motion
      scene.fluid.centre_of_mass = "bulk";
  }
  scene.box.lattice = {wanted.lattice.begin(), wanted.lattice.end()};
  scene.box.z = "walls", scene.box.piston = wanted.v_P;
  scene.transport.eta = wanted.eta;
  scene.scheme.name = wanted.scheme, scene.scheme.dt.value = wanted.dt;
  scene.run.equilibrate = wanted.equilibrate;
  scene.run.seed = static_cast<std::int64_t>(wanted.seed);
  scene.run.steps = steps_of(wanted, scene);
  scene.run.sample_every = std::max<std::int64_t>(1, scene.run.steps / frames);
  scene.profile = {.axis = "z", .bins = wanted.lattice[2], .every = scene.run.sample_every, .quantities = {}};
  return scene;
}

std::vector<ShockRow> run_shocks(std::string const& title, std::vector<ShockCase> const& cases,
                                 ReproduceOptions const& options, Context const& context) {
  std::vector<DrivenRun> runs;
  for (auto const& one : cases)
    runs.push_back({one.name, one.scene});
  auto rows = run_study<ShockRow>(
      title, runs, {.directory = options.directory, .threads = options.threads}, context,
      [&](std::size_t k, RunResult const& run, Store const& store) { return row_of(cases[k], run, store); },
      [&](std::size_t k, std::string const& why) { return failed(cases[k], why); });
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (!rows[k].failed()) {
      auto const settings = settings_of(cases[k].scene, 1);
      rows[k].Re_l = front_reynolds_number(settings, *shock_before_piston(settings));
    }
  return rows;
}

} // namespace mesobridge::workflows
