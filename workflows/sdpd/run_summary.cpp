#include "workflows/sdpd/run_summary.hpp"
#include "sdpd/setup/balance.hpp"
#include "workflows/sdpd/detonation.hpp"
#include "workflows/sdpd/flow.hpp"
#include "workflows/sdpd/kept_tolerances.hpp"
#include "workflows/sdpd/measured_series.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/riemann_problem.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/shock.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {
namespace {

void put_rejections(Json& json, std::string const& name, sdpd::PairCounts const& counts) {
  double const proposed = static_cast<double>(std::max<std::uint64_t>(counts.proposed, 1));
  json[name + "_out_of_domain"] = static_cast<double>(counts.out_of_domain) / proposed;
  json[name + "_metropolis"] = static_cast<double>(counts.metropolis) / proposed;
}

/// The means of the measurements that the scene asks for.
void put_measured(Json& json, RunFile const& file, Scene const& scene, OutputUnits const& units) {
  for (auto const& one : measured_components(file.store(), scene, units)) {
    auto const key = columns_of(one.of, units)[one.component];
    if (json.contains(key))
      throw std::logic_error("a measurement has the name of another result: " + key);
    put(json, key, one.mean());
  }
}

/// The energy that a driven run misses, over what it has turned over, by all its samples (sdpd/README.md, Eq.
/// (S73)).
double balance_error(RunFile const& file, OutputUnits const& units) {
  auto const of = [&](std::string const& name) { return file.column(name + units.energy_key); };
  auto const balanced = of("energy"), internal = of("internal_energy"); // balanced: less what is given
  std::vector<double> total(balanced.size());
  for (char const* part : {"kinetic_energy", "internal_energy", "potential_energy", "chemical_energy"})
    for (std::size_t k = 0; double const value : of(part))
      total[k++] += value;
  sdpd::BalanceSeries series;
  for (std::size_t k = 0; k < balanced.size(); ++k) {
    series.errors.push_back(balanced[k] - balanced[0]);
    series.given.push_back((total[k] - balanced[k]) - (total[0] - balanced[0]));
    series.exchanged.push_back(internal[k] - internal[0]);
  }
  return sdpd::error_share(series);
}

/// How many independent samples each mean and variance rests on; errors of less than twenty are rough.
Json independent_samples(sdpd::Equilibrium const& e, sdpd::Features const& features) {
  Json json{{"T_kin", e.T_kin.n_eff}, {"P", e.P.n_eff}};
  if (features.energies)
    json["T_int"] = e.T_int.n_eff, json["e"] = e.eps.mean.n_eff;
  if (features.densities)
    json["rho"] = e.rho.mean.n_eff, json["rho_variance"] = e.rho.variance.n_eff;
  return json;
}

} // namespace

Json run_summary(RunResult const& result, sdpd::Simulation const& simulation, RunFile const& file,
                 OutputUnits const& units, Json const& calibration) {
  auto const& scene = result.scene;
  auto const& settings = result.settings;
  auto const& e = result.equilibrium;
  auto const features = settings.features();
  auto in = [](cg::Estimate const& estimate, double unit) {
    return cg::Estimate{estimate.mean * unit, estimate.se * unit, estimate.n_eff};
  };
  Json json;
  json["title"] = scene.title;
  json["n"] = simulation.size();
  json["method"] = scene.method.name;
  if (features.densities)
    json["K"] = settings.K();
  json["dt_reduced"] = settings.dt;
  json["dt" + units.time_key] = settings.dt * units.time;
  json["steps"] = scene.run.steps;
  json["neighbours"] = result.neighbours;
  auto const [density_scale, density_self] = density_correction_of(scene);
  json["density_scale"] = density_scale;
  json["density_self"] = density_self;
  if (!calibration.is_null())
    json["density_calibration"] = calibration;
  put(json, "T_kin" + units.temperature_key, in(e.T_kin, units.temperature));
  if (features.energies)
    put(json, "T_int" + units.temperature_key, in(e.T_int, units.temperature));
  put(json, "P" + units.pressure_key, in(e.P, units.pressure));
  if (features.densities) {
    put(json, "rho" + units.density_key, in(e.rho.mean, units.density));
    put(json, "rho_variance", in(e.rho.variance, units.density * units.density));
    put(json, "P_internal" + units.pressure_key, in(e.P_i.mean, units.pressure));
    put(json, "pairing_fraction", e.pairing);
    put(json, "crystal_fraction", e.crystal);
  }
  if (features.energies) {
    put(json, "e" + units.specific_energy_key, in(e.eps.mean, units.specific_energy));
    put(json, "energy_drift_per_reduced_time", cg::Estimate{e.drift.rate, e.drift.se, 8});
    put(json, "energy_drift_per" + (units.time_key.empty() ? "_time" : units.time_key),
        cg::Estimate{e.drift.rate / units.time, e.drift.se / units.time, 8});
    if (is_driven(scene))
      json["energy_balance_error"] = balance_error(file, units);
  }
  for (std::string const energy : {"kinetic_energy", "potential_energy"})
    if (auto const mean = file.mean(energy + units.energy_key); mean && !features.densities)
      put(json, energy + "_per_particle" + units.energy_key,
          in(*mean, 1 / static_cast<double>(simulation.size())));
  put_measured(json, file, scene, units);
  json["n_eff"] = independent_samples(e, features);
  if (settings.features().reacts)
    json["progress"] = simulation.observe().progress; // at the end
  if (auto const shock = shock_of(file.store(), scene, settings))
    put_shock(json, *shock, units);
  if (auto const detonation = detonation_of(file.store(), scene, settings))
    put_detonation(json, *detonation, units);
  if (auto const problem = riemann_problem(scene, settings))
    if (auto const found = compare(*problem, file.store(), scene, units))
      put_riemann(json, *problem, *found, units);
  if (auto const flow = flow_of(file.store(), scene, settings))
    put_flow(json, *flow, units);
  if (auto const shock = shock_before_piston(settings))
    json["Re_l"] = front_reynolds_number(settings, *shock);
  put_rejections(json, "rejected", simulation.pair_counts());
  if (settings.conducts())
    put_rejections(json, "conduction_rejected", simulation.conduction_counts());
  auto const p = simulation.observe().momentum;
  json["momentum" + units.momentum_key] = norm(p) * units.momentum;
  if (settings.noise)
    json["diffusion_excess_at_most"] = diffusion_excess_at_most(result);
  json["findings"] = findings_json(result.findings);
  return json;
}

} // namespace mesobridge::workflows
