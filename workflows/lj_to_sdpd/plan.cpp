#include "workflows/lj_to_sdpd/plan.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// Steps of the kinds of runs. The thesis took 5e5 steps of 1000 particles.
struct Lengths {
  std::int64_t calibrate, equilibrate, fluid, ideal, drift;
};

Lengths lengths(md::Preset preset) {
  switch (preset) {
  case md::Preset::quick:
    return {2400, 1000, 3600, 2400, 1600};
  case md::Preset::standard:
    return {20000, 10000, 60000, 60000, 20000};
  case md::Preset::paper:
    break;
  }
  return {100000, 50000, 500000, 500000, 100000};
}

Scene base(double K, double dt, std::int64_t seed) {
  Scene scene;
  scene.fluid.rho = fluid_rho;
  scene.fluid.T = fluid_T;
  scene.particles.N = 1000;
  scene.particles.K = K;
  scene.transport.eta = 2e-3;
  scene.scheme.dt = {.value = dt, .reduced = true};
  scene.run.sample_every = 4;
  scene.run.checkpoint_every = 0;
  scene.run.seed = seed;
  return scene;
}

/// A kernel without pairing, and densities whose constants make the fluid's pressure and mean density those
/// of its equation of state.
void calibrate_densities(Scene& scene, std::int64_t steps) {
  scene.particles.kernel = "wendland-c4";
  scene.particles.density = "calibrated";
  scene.particles.calibration_steps = steps;
}

/// The drift's printed laws are those of the cubic kernel and of plain densities.
void take_plain_densities(Scene& scene) {
  scene.particles.kernel = "cubic";
  scene.particles.density = "plain";
}

Scene ideal_gas(double K, double dt, std::int64_t seed) {
  Scene scene = base(K, dt, seed);
  scene.fluid.eos = "ideal-gas";
  scene.fluid.m0 = 1e-25;
  scene.title = fmt::format("Ideal gas, K = {:g}, dt = {:g}", K, dt);
  return scene;
}

} // namespace

SdpdPlan sdpd_plan(md::Preset preset, std::filesystem::path const& model, std::int64_t seed) {
  auto const steps = lengths(preset);
  SdpdPlan plan;
  auto fluid = [&](double K, std::string const& eos, std::string const& label) {
    // Small particles are fast and have small heat capacities: they need the thesis's short step.
    Scene scene = base(K, K < 50 ? 0.03 : K < 1000 ? 0.06 : 0.1, seed);
    scene.fluid.eos = eos;
    calibrate_densities(scene, steps.calibrate);
    scene.title = fmt::format("Lennard-Jones argon ({}), K = {:g}", label, K);
    // The structure of large, hardly fluctuating particles takes longer to settle.
    scene.run.equilibrate = (K < 1000 ? 1 : K < 10000 ? 2 : 4) * steps.equilibrate;
    scene.run.steps = steps.fluid;
    return scene;
  };
  std::vector<double> sizes{10, 100, 1000, 10000};
  if (preset != md::Preset::quick)
    sizes = {5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 25000};
  for (double const K : sizes)
    plan.fluid.push_back({fmt::format("fitted-K{:g}", K), fluid(K, model.string(), "fitted")});
  plan.published.push_back({"published-K100", fluid(100, "argon", "published")});
  for (double const K : {10.0, 100.0}) {
    Scene scene = ideal_gas(K, K < 50 ? 0.04 : 0.1, seed);
    calibrate_densities(scene, steps.calibrate);
    scene.run.equilibrate = steps.equilibrate;
    scene.run.steps = steps.ideal;
    plan.ideal.push_back({fmt::format("ideal-K{:g}", K), scene});
  }
  struct Row {
    double K;
    std::vector<double> dts;
  };
  for (auto const& [K, dts] : {Row{10, {0.15, 0.2, 0.25, 0.3, 0.35}}, Row{50, {0.3, 0.35, 0.4, 0.45, 0.5}},
                               Row{100, {0.3, 0.35, 0.4, 0.45, 0.5}}})
    for (double const dt : dts) {
      Scene scene = ideal_gas(K, dt, seed);
      take_plain_densities(scene);
      scene.run.equilibrate = steps.drift / 4;
      scene.run.steps = steps.drift;
      plan.drift.push_back({fmt::format("drift-K{:g}-dt{:g}", K, dt), scene});
    }
  return plan;
}

} // namespace mesobridge::workflows
