#include "workflows/sdpd/run_checks.hpp"
#include "fitting/eos/linear_isochore.hpp"
#include "sdpd/lammps/lammps_engine.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/thermodynamics/particle_eos.hpp"
#include "workflows/scene/checks.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "workflows/study/automatic_dt.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr std::int64_t least_samples = 32; ///< for standard errors, and for the drift of the energy
constexpr std::int64_t most_steps = 1'000'000'000'000'000; ///< their sum is exact as a double

void check_steps(Scene::Run const& run) {
  for (auto const& [key, steps] : {std::pair("run.steps", run.steps), {"run.equilibrate", run.equilibrate}})
    require(steps <= most_steps, key, steps, fmt::format("must be <= {}", most_steps));
  require(run.steps / least_samples >= run.sample_every, "run.steps", run.steps,
          fmt::format("must be at least {} run.sample_every = {}, or no errors can be estimated",
                      least_samples, double(least_samples) * double(run.sample_every)));
}

/// Positions of size one that are stored as doubles do not notice shorter steps.
void check_time_step(sdpd::SimulationSettings const& settings) {
  constexpr double shortest = 1e-12;
  require(settings.dt >= shortest, "scheme.dt", settings.dt,
          fmt::format("must be >= {} reduced units of time: shorter steps move no particle", shortest));
}

/// The edges of the box are counted in particles, so this asks for a number of them.
void check_box(Scene const& scene, int threads) {
  Scene one = scene;
  one.particles.N = 1, one.box = {}, one.regions.clear();
  auto const settings = settings_for_check(one, threads);
  sdpd::check_units(settings);
  double const reach = (settings.range() + sdpd::skin_of(settings)) / settings.spacing();
  double const edge = std::max(1.0, std::ceil(2 * reach * (1 - 1e-14)));
  auto const N = scene.particles.N;
  auto const why = fmt::format("the box must be twice as wide as the interaction and the skin of its lists "
                               "reach, which is {:.4g} mean distances between particles",
                               reach);
  require(static_cast<double>(N) >= edge * edge * edge, "particles.N", N,
          fmt::format("must be >= {:.0f}, {:.0f} along each edge: {}", edge * edge * edge, edge, why));
  auto const lattice = lattice_of(N);
  auto const side = static_cast<double>(std::llround(std::cbrt(static_cast<double>(N))));
  require(lattice[0] >= edge, "particles.N", N,
          fmt::format("its lattice of {} x {} x {} is too narrow; take {:.0f} or {:.0f}: {}", lattice[0],
                      lattice[1], lattice[2], side * side * side, side * side * (side + 1), why));
}

/// The model must have the state that the fluid begins in.
void check_state(Scene const& scene) {
  if (!scene.features().densities)
    return;
  try {
    std::visit([&](auto const& of) { of.energy_from_temperature(scene.fluid.T, scene.fluid.rho); },
               eos_of(scene));
  } catch (PhysicsError const& error) {
    throw PhysicsError(
        fmt::format("fluid.rho = {:g} at fluid.T = {:g}: {}", scene.fluid.rho, scene.fluid.T, error.what()));
  }
}

/// What a reaction asks of a model: its heat capacity and the mass of a molecule.
struct PartOfReaction {
  bool constant_c_v;
  double c_v, m0; ///< the former in k_B a molecule
};

PartOfReaction part_of(fitting::AnyEos const& any) {
  return std::visit(
      []<class Model>(Model const& of) -> PartOfReaction {
        if constexpr (fitting::LinearModel<Model>)
          return {true, of.c_v() * of.molecular_mass() / of.boltzmann(), of.molecular_mass()};
        else
          return {false, 0, of.molecular_mass()};
      },
      any);
}

/// A particle may become all product, which has fewer molecules where these are heavier.
void check_parts_of_reaction(Scene const& scene) {
  if (!scene.features().reacts)
    return;
  auto const reactant = part_of(eos_of(scene)), product = part_of(product_of(scene));
  auto const& name = scene.reaction.product.value();
  for (auto const& [key, value, part] :
       {std::tuple("fluid.eos", scene.fluid.eos, reactant), {"reaction.product", name, product}})
    require(part.constant_c_v, key, value,
            "cannot be a part of a fluid that reacts: models with a constant heat capacity can");
  double const K = scene.particles.K, molecules = K * reactant.m0 / product.m0;
  bool const free = scene.noise() && scene.fluid.centre_of_mass == "free";
  double const C = molecules * product.c_v - (free ? 1.5 : 0);
  require((!free || molecules >= 1) && C > sdpd::least_heat_capacity, "particles.K", K,
          fmt::format("is too small: as reaction.product = \"{}\" a particle is {:.4g} molecules of the heat "
                      "capacity {:.4g} k_B{}; it must be one at least, of more than {} k_B",
                      name, molecules, C, free ? " without its centre of mass" : "",
                      sdpd::least_heat_capacity));
}

/// The ranks agree on the settings before the first of them looks for a time step.
void check_for_lammps(Scene const& scene) {
  require(!scene.scheme.dt.automatic, "scheme.dt", "auto", "the LAMMPS engine wants a number");
  sdpd::refuse_for_lammps(settings_of(scene, 1));
}

} // namespace

sdpd::SimulationSettings settings_for_check(Scene const& scene, int threads) {
  auto settings = settings_of(scene, threads);
  if (scene.scheme.dt.automatic)
    settings.dt = largest_tried_dt(scene);
  return settings;
}

void check_run(Scene const& scene, int threads) {
  check_steps(scene.run);
  check_series(scene);
  check_state(scene);
  check_parts_of_reaction(scene);
  if (scene.box == Scene::Box{} && scene.regions.empty()) // of others the engine says what they lack
    check_box(scene, threads);
  auto const settings = settings_for_check(scene, threads);
  sdpd::check(settings);
  check_time_step(settings);
  if (scene.scheme.dt.automatic)
    for (auto const& trial : time_step_trials(scene))
      sdpd::check(settings_of(trial.scene, 1));
  if (wants_calibration(scene))
    sdpd::check_calibration(calibrated_settings(scene, threads), scale_condition_of(scene));
  if (wants_trials_of_viscosity(scene))
    check_viscosity_trials(scene);
}

Scene load_run(std::filesystem::path const& file, std::vector<std::string> const& overrides, int threads,
               Engine engine) {
  Scene scene = load_scene(file, overrides);
  try {
    check_run(scene, threads);
    if (engine == Engine::lammps)
      check_for_lammps(scene);
  } catch (InputError const& error) {
    std::string const message = error.what();
    throw InputError(
        fmt::format("{}: {}", place_of(file, overrides, message.substr(0, message.find(' '))), message));
  }
  return scene;
}

} // namespace mesobridge::workflows
