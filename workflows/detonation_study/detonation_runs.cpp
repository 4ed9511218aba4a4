#include "workflows/detonation_study/detonation_runs.hpp"
#include "sdpd/observe/frame_blocks.hpp"
#include "workflows/study/driven_runs.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {

template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, DetonationRow>
void for_each_member(Result& r, F const& f) {
  f("K", r.K), f("Z", r.Z), f("eta", r.eta), f("ramp", r.ramp), f("spacing", r.spacing);
  f("particles", r.particles), f("piston", r.piston), f("D", r.D), f("change_of_D", r.change_of_D);
  f("zone", r.zone), f("D_theory", r.D_theory), f("zone_theory", r.zone_theory), f("times", r.times);
  f("fronts", r.fronts), f("depth", r.depth), f("P", r.P), f("P_se", r.P_se), f("progress", r.progress);
  f("slice_rho", r.slice_rho), f("slice_P", r.slice_P), f("failure", r.failure);
}

namespace {

constexpr double rho = 1104, T = 300, v_P = 1764;      // SI
constexpr double molecule = 61.04 * 1.66053906660e-27; // kg
constexpr double layer = 24;         // thickness of the burnt layer [spacings]: 50 nm at K = 100
constexpr std::int64_t frames = 150; // of a run

/// Steps until a wave of the velocity of the detonation has come near the far end: from the burnt layer, or
/// from a piston, before which it is a mere shock for a time.
std::int64_t steps_of(DetonationCase const& of, Scene const& scene, double D) {
  double const way = static_cast<double>(of.lattice[2]) - 12,
               time = settings_of(scene, 1).units().velocity() / D;
  double const late = of.piston ? 0.12 * way : -layer;
  return static_cast<std::int64_t>((way + late) * time / scene.scheme.dt.value);
}

/// Small enough for the motion, in reduced units, and for a reaction zone of 2.8 ps at Z = 1e15 1/s.
double step_of(DetonationCase const& of, Scene const& scene) {
  constexpr double of_motion = 0.003, of_reaction = 25e-15, Z = 1e15;
  return std::min(of_motion, of_reaction * Z / of.Z / settings_of(scene, 1).units().time());
}

/// As if the detonation had come so far already.
Scene::Region burnt_layer(DetonationCase const& of, fitting::Shock const& detonation) {
  Scene::Region burnt{.name = "burnt layer", .shape = "slab"};
  burnt.axis = "z";
  burnt.to = {{layer * spacing_of(of), false}};
  burnt.rho = detonation.behind.rho, burnt.T = detonation.behind.T, burnt.progress = 1;
  burnt.velocity = {0, 0, detonation.v_P};
  return burnt;
}

DetonationRow start_of(DetonationCase const& of, Scene const& scene,
                       sdpd::SimulationSettings const& settings) {
  return {.K = of.K,
          .Z = of.Z,
          .eta = of.eta,
          .ramp = settings.faces[2][0].motion.ramp, // the scene may leave it to the equation of state
          .spacing = spacing_of(of),
          .particles = scene.particles.N,
          .piston = of.piston,
          .D = {},
          .change_of_D = {},
          .zone = {}};
}

DetonationRow row_of(DetonationCase const& of, RunResult const& run, Store const& store) {
  auto row = start_of(of, run.scene, run.settings);
  auto const theory = detonation_theory(run.settings);
  if (theory)
    row.D_theory = theory->chapman_jouguet.v_S, row.zone_theory = theory->zone_length();
  if (auto const all = theory ? detonation_frames(store, run.scene, run.settings, *theory) : std::nullopt)
    for (auto const& frame : all->frames)
      if (auto const front = sdpd::front_position(frame.flow, all->scale))
        row.times.push_back(frame.flow.time), row.fronts.push_back(*front);
  auto const found = detonation_of(store, run.scene, run.settings);
  if (!found) {
    row.failure = fmt::format("no steady detonation in the box within {} steps", run.scene.run.steps);
    return row;
  }
  row.D = found->measured.D, row.change_of_D = found->measured.change_of_D, row.zone = found->measured.zone;
  row.depth = found->measured.profile.depth;
  for (auto const& P : found->measured.profile.P)
    row.P.push_back(P.mean), row.P_se.push_back(P.se);
  for (auto const& progress : found->measured.profile.progress)
    row.progress.push_back(progress.mean);
  row.slice_rho = found->rho, row.slice_P = found->P;
  return row;
}

} // namespace

double spacing_of(DetonationCase const& of) {
  return std::cbrt(of.K * molecule / rho);
}

cg::Estimate DetonationRow::time_to_detonation() const {
  std::size_t const from = fronts.size() / 2; // the second half is surely behind the transition
  double const t = sdpd::mean_of(std::span(times).subspan(from)),
               z = sdpd::mean_of(std::span(fronts).subspan(from));
  return {t - z / D.mean, z / (D.mean * D.mean) * D.se, D.n_eff};
}

Scene detonation_scene(DetonationCase const& of) {
  Scene scene;
  scene.title = fmt::format("nitromethane, K = {:g}, Z = {:g} 1/s, eta = {:g} Pa s", of.K, of.Z, of.eta);
  scene.fluid.eos = "nitromethane", scene.fluid.rho = rho, scene.fluid.T = T;
  scene.particles.K = of.K, scene.particles.density = "plain", scene.particles.disorder = 0.02;
  scene.particles.N = of.lattice[0] * of.lattice[1] * of.lattice[2];
  scene.box.lattice = {of.lattice.begin(), of.lattice.end()};
  scene.box.z = "walls";
  scene.reaction.product = "nitromethane-products";
  scene.reaction.heat_per_molecule = 4.78e-19;
  scene.reaction.parameters["Z"] = of.Z, scene.reaction.parameters["E_a"] = 3e-19;
  scene.transport.eta = of.eta;
  scene.scheme.name = of.K < 50 ? "ems" : "ssa", scene.scheme.dt.value = step_of(of, scene);
  auto const detonation = detonation_theory(settings_of(scene, 1))->chapman_jouguet;
  if (of.piston)
    scene.box.piston = v_P, scene.box.ramp = of.ramp;
  else
    scene.regions = {burnt_layer(of, detonation)};
  scene.run.seed = static_cast<std::int64_t>(of.seed);
  scene.run.steps = steps_of(of, scene, detonation.v_S);
  scene.run.sample_every = std::max<std::int64_t>(1, scene.run.steps / frames);
  scene.profile = {
      .axis = "z", .bins = of.lattice[2] * 4 / 5, .every = scene.run.sample_every, .quantities = {}};
  return scene;
}

DetonationTheory nitromethane_theory() {
  return detonation_theory(settings_of(detonation_scene({.name = "", .lattice = {12, 12, 100}}), 1)).value();
}

std::vector<DetonationRow> run_detonations(std::string const& title, std::vector<DetonationCase> const& cases,
                                           ReproduceOptions const& options, Context const& context) {
  std::vector<DrivenRun> runs;
  for (auto const& one : cases)
    runs.push_back({one.name, detonation_scene(one)});
  return run_study<DetonationRow>(
      title, runs, {.directory = options.directory, .threads = options.threads}, context,
      [&](std::size_t k, RunResult const& run, Store const& store) { return row_of(cases[k], run, store); },
      [&](std::size_t k, std::string const& why) {
        auto const settings = settings_of(runs[k].scene, 1);
        auto row = start_of(cases[k], runs[k].scene, settings);
        if (auto const theory = detonation_theory(settings))
          row.D_theory = theory->chapman_jouguet.v_S, row.zone_theory = theory->zone_length();
        row.failure = why;
        return row;
      });
}

Json row_json(DetonationRow const& row) {
  Json json{{"model", "SDPD"},
            {"K", row.K},
            {"Z_per_s", row.Z},
            {"eta_Pa_s", row.eta},
            {"particles", row.particles},
            {"D_chapman_jouguet_m_s", row.D_theory},
            {"zone_znd_m", row.zone_theory}};
  if (row.piston)
    json["ramp_s"] = row.ramp;
  if (row.failed()) {
    json["failure"] = row.failure;
    return json;
  }
  put(json, "D_m_s", row.D);
  put(json, "change_of_D_m_s", row.change_of_D);
  put(json, "zone_m", row.zone);
  if (row.piston)
    put(json, "time_to_detonation_s", row.time_to_detonation());
  return json;
}

Reproduced reproduced(std::string const& title, std::string const& lead,
                      std::vector<DetonationRow> const& rows, Section first) {
  Reproduced found;
  for (auto const& row : rows)
    found.summary["rows"].push_back(row_json(row));
  found.report.title = title, found.report.lead = lead;
  found.report.sections = {std::move(first)};
  found.report.sources = {"Faure 2017"};
  return found;
}

} // namespace mesobridge::workflows
