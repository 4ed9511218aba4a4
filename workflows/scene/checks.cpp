#include "workflows/scene/checks.hpp"
#include "fitting/eos/list.hpp"
#include "md/error.hpp"
#include "sdpd/method/list.hpp"
#include "sdpd/scheme/list.hpp"
#include "workflows/nearest.hpp"
#include "workflows/scene/box_checks.hpp"
#include "workflows/scene/driven.hpp"
#include "workflows/scene/pair_checks.hpp"
#include "workflows/scene/quantities.hpp"
#include "workflows/scene/reaction_checks.hpp"
#include "workflows/scene/region_checks.hpp"
#include "workflows/scene/tolerance.hpp"
#include <algorithm>
#include <tuple>

namespace mesobridge::workflows {

namespace {

std::vector<std::string> built_in_models() {
  std::vector<std::string> names;
  for (auto const& material : fitting::materials())
    names.push_back(material.name);
  return names;
}

bool is_built_in(std::string const& eos) {
  return std::ranges::find(fitting::materials(), eos, &fitting::Material::name) != fitting::materials().end();
}

/// Whether a built-in model is in Lennard-Jones units.
bool is_reduced(std::string const& eos) {
  return std::visit([](auto const& model) { return model.boltzmann() == 1; }, fitting::material(eos).eos);
}

/// What a model asks of the scene, and of the size of its particles.
void check_model(Scene const& scene, Places const& places, std::string const& eos, std::string const& eos_key,
                 double K, std::string const& K_key) {
  bool const reduced = scene.units == UnitSystem::lj;
  if (is_built_in(eos))
    require_together(is_reduced(eos) == reduced, places, eos_key, eos,
                     reduced ? "is a model in SI; scenes with units = \"lj\" take \"lj\" or a reduced model"
                             : "is a reduced model, which wants units = \"lj\"");
  if (eos != "ideal-gas")
    return;
  require_together(scene.fluid.m0.has_value(), places, eos_key, eos,
                   "needs the mass of a molecule, fluid.m0");
  require_together(K > 1, places, K_key, K,
                   "must be > 1 for the ideal gas: its heat capacity is 3/2 (K - 1) k_B");
}

void check_fluid(Scene const& scene, Places const& places) {
  auto const& fluid = scene.fluid;
  check_model(scene, places, fluid.eos, "fluid.eos", scene.particles.K, "particles.K");
  bool ideal = fluid.eos == "ideal-gas";
  if (auto const& product = scene.reaction.product) {
    check_model(scene, places, *product, "reaction.product", scene.particles.K, "particles.K");
    ideal = ideal || *product == "ideal-gas";
  }
  for (std::size_t k = 0; k < scene.regions.size(); ++k) {
    auto const& region = scene.regions[k];
    auto const eos = region.eos.value_or(fluid.eos);
    check_model(scene, places, eos, fmt::format("region.{}.eos", k + 1), region.K.value_or(scene.particles.K),
                fmt::format("region.{}.K", k + 1));
    ideal = ideal || eos == "ideal-gas";
  }
  if (fluid.m0)
    require_together(ideal, places, "fluid.m0", *fluid.m0,
                     "allowed with eos = \"ideal-gas\" only; other models know it");
}

constexpr std::int64_t least_calibration = 200;

void check_density(Scene const& scene, Places const& places) {
  auto const& [density, scale, self] =
      std::tie(scene.particles.density, scene.particles.density_scale, scene.particles.density_self);
  bool const takes_constants = density == "given" || density == "auto" || density.starts_with("calibrated");
  for (auto const& [key, value] :
       {std::pair("particles.density_scale", scale), {"particles.density_self", self}})
    if (value)
      require_together(
          takes_constants, places, key, *value,
          fmt::format("allowed with density = \"given\", \"calibrated\" or \"auto\"; here it is \"{}\"",
                      density));
  require_together(scale.has_value() == self.has_value() && (scale || density != "given"), places,
                   "particles.density", density,
                   "needs both density_scale and density_self" +
                       std::string(density == "given" ? "" : ", or neither"));
  auto const steps = scene.particles.calibration_steps;
  require_together(
      steps == 0 || steps >= least_calibration, places, "particles.calibration_steps", steps,
      fmt::format("must be >= {}, or 0 for a number that goes with the run's", least_calibration));
  require_together(density != "calibrated-shocked" || scene.box.piston.value_or(0) > 0, places,
                   "particles.density", density,
                   "needs a piston that moves into the fluid, box.piston > 0, whose shock makes the state");
  if (scale)
    require_together(std::abs(*self) < *scale, places, "particles.density_self", *self,
                     fmt::format("must lie between -c and c, c = density_scale = {}", *scale));
}

/// A share of the energy that is turned over may get lost where something turns it over.
void check_balance(Scene const& scene, Places const& places) {
  auto const& drift = *scene.scheme.drift;
  require_together(is_driven(scene), places, "scheme.drift", drift,
                   "a share of the energy that is turned over, is for scenes that something drives: regions, "
                   "a reaction, a piston, walls that slide, open faces or a body force; give a rate, such as "
                   "\"1e-6/ps\", or a bias");
  require_together(scene.scheme.energy == "free", places, "scheme.drift", drift,
                   "wants energy = \"free\": with \"kept\" the energy balances at any time step");
}

void check_tolerance(Scene const& scene, Places const& places) {
  auto const& scheme = scene.scheme;
  auto check = [&](char const* key, std::optional<std::string> const& text, auto const& parse) {
    if (!text)
      return;
    require_together(scheme.dt.automatic, places, key, *text, "wants dt = \"auto\", whose error it bounds");
    try {
      parse(*text);
    } catch (InputError const& error) {
      throw InputError(fmt::format("{}: {} = \"{}\": {}", places.of(key), key, *text, error.what()));
    }
  };
  check("scheme.drift", scheme.drift, [&](std::string const& text) {
    balance_tolerance(scheme) ? parse_share(text) : parse_rate(text, scene.units);
  });
  check("scheme.bias", scheme.bias, [](std::string const& text) { parse_share(text); });
  check("scheme.dynamics", scheme.dynamics, [](std::string const& text) { parse_share(text); });
  if (scheme.dynamics)
    require_together(scene.noise() && scheme.conservative != "none", places, "scheme.dynamics",
                     *scheme.dynamics, "must not be given: nothing diffuses without noise or motion");
  if (scheme.drift)
    require_together(
        scene.features().energies, places, "scheme.drift", *scheme.drift,
        "must not be given: the thermostat of dpd keeps no energy that could drift; give a bias");
  if (balance_tolerance(scheme))
    check_balance(scene, places);
  require_together(
      !scheme.dt.automatic || scheme.drift || scheme.bias || scheme.dynamics, places, "scheme.dt", "\"auto\"",
      "needs a tolerance: scheme.drift, such as \"1e-6/ps\" or, in scenes that something drives, "
      "\"1%\", scheme.bias, such as \"0.5%\", or scheme.dynamics, such as \"5%\"");
}

} // namespace

namespace {

void resolve_model_path(std::string& eos, std::string const& key, std::filesystem::path const& folder,
                        Places const& places) {
  if (is_built_in(eos))
    return;
  if (!eos.ends_with(".toml"))
    throw InputError(fmt::format("{}: {} = \"{}\": must be one of {} or the path of a model file (.toml){}",
                                 places.of(key), key, eos, fitting::material_names(),
                                 did_you_mean(eos, built_in_models())));
  auto const path = std::filesystem::absolute(folder / eos).lexically_normal();
  require_together(std::filesystem::is_regular_file(path), places, key, eos,
                   fmt::format("there is no model file '{}'", path.string()));
  eos = path.string();
}

} // namespace

void resolve_model_paths(Scene& scene, std::filesystem::path const& folder, Places const& places) {
  if (!scene.features().densities)
    return;
  resolve_model_path(scene.fluid.eos, "fluid.eos", folder, places);
  if (auto& product = scene.reaction.product)
    resolve_model_path(*product, "reaction.product", folder, places);
  for (std::size_t k = 0; k < scene.regions.size(); ++k)
    if (auto& eos = scene.regions[k].eos)
      resolve_model_path(*eos, fmt::format("region.{}.eos", k + 1), folder, places);
}

namespace {

void check_viscosity(Scene const& scene, Places const& places) {
  auto const& transport = scene.transport;
  bool const realised = transport.eta_means == "realised";
  require_together(!realised || (scene.noise() && scene.scheme.conservative != "none"), places,
                   "transport.eta_means", transport.eta_means,
                   "must be \"pair\": without noise or motion trials show no viscosity");
  if (transport.eta_pairs)
    require_together(realised, places, "transport.eta_pairs", *transport.eta_pairs,
                     "allowed with eta_means = \"realised\" only; else it is eta itself");
}

void check_keys(std::type_identity<sdpd::Sdpd>, Scene const& scene, Places const& places) {
  check_fluid(scene, places);
  check_density(scene, places);
  check_reaction(scene, places);
  check_viscosity(scene, places);
  double const limit = 5 * scene.transport.friction() / 3;
  require_together(
      scene.transport.zeta < limit, places, "transport.zeta", scene.transport.zeta,
      fmt::format("must be < 5 eta / 3 = {:.6g}, or the friction coefficient a_ij turns negative", limit));
}

template <std::derived_from<sdpd::PairFluid> Method>
void check_keys(std::type_identity<Method>, Scene const& scene, Places const& places) {
  check_pair_fluid(scene, places);
}

void check_scheme(Scene const& scene, Places const& places) {
  auto const& scheme = scene.scheme;
  auto const particles = scene.features();
  auto const why = sdpd::refusal(sdpd::pair_integrator(scheme.name), particles, scene.noise());
  require_together(!why, places, "scheme.name", scheme.name, why.value_or(""));
  require_together(particles.energies || scheme.energy == "free", places, "scheme.energy", scheme.energy,
                   "the particles have no internal energies that could give or take energy");
}

/// The quantities that the scene names must be its method's, and there must be some.
void check_quantities(Scene const& scene, Places const& places, std::string const& section,
                      std::int64_t every, std::vector<std::string> const& named,
                      std::vector<NamedQuantity> const& known) {
  auto const has = chosen({}, known, scene.features());
  for (auto const& name : named)
    require_together(std::ranges::find(has, name) != has.end(), places,
                     section + (section == "film" ? ".quantity" : ".quantities"), name,
                     fmt::format("there is no such quantity in this box with particles of {}; there are: {}",
                                 scene.method.name,
                                 has.empty() ? "none" : fmt::format("{}", fmt::join(has, ", "))));
  require_together(every == 0 || !has.empty(), places, section + ".every", every,
                   fmt::format("must be 0: particles of {} have none of the quantities", scene.method.name));
}

void check_film(Scene const& scene, Places const& places) {
  auto const& film = scene.film;
  if (film.quantity) {
    check_quantities(scene, places, "film", 1, {*film.quantity}, film_quantities());
    require_together(film.every <= scene.run.steps, places, "film.every", film.every,
                     fmt::format("must be <= run.steps = {}, or 0 for six frames", scene.run.steps));
    return;
  }
  require_together(film == Scene::Film{}, places, "film.quantity", "not given",
                   "must be given where other keys of the film are: it is what colours the particles");
}

/// Profiles, histograms and series on schedules that the run can keep.
void check_schedules(Scene const& scene, Places const& places) {
  auto const& profile = scene.profile;
  auto const& histogram = scene.histogram;
  check_quantities(scene, places, "profile", profile.every, profile.quantities, profile_quantities());
  check_quantities(scene, places, "histogram", histogram.every, histogram.quantities, histogram_quantities());
  check_quantities(scene, places, "series", scene.series.every, scene.series.quantities, series_quantities());
  check_film(scene, places);
  for (auto const& [key, every] :
       {std::pair("profile.every", profile.every), {"histogram.every", histogram.every}})
    require_together(every <= scene.run.steps, places, key, every,
                     fmt::format("must be <= run.steps = {}, or 0 for none", scene.run.steps));
}

} // namespace

void check_together(Scene const& scene, Places const& places) {
  check_box(scene, places);
  check_regions(scene, places);
  sdpd::for_method(scene.method.name, [&](auto type) { check_keys(type, scene, places); });
  check_scheme(scene, places);
  check_tolerance(scene, places);
  check_schedules(scene, places);
  constexpr std::int64_t least_instants = 16; // what an estimate of errors needs
  require_together(
      scene.series.every <= scene.run.steps / least_instants, places, "series.every", scene.series.every,
      fmt::format("must be <= run.steps/{} = {}, or there are too few rows for errors; 0 for none",
                  least_instants, scene.run.steps / least_instants));
  require_together(scene.run.instant_every <= scene.run.steps / least_instants, places, "run.instant_every",
                   scene.run.instant_every,
                   fmt::format("must be <= run.steps/{} = {}, or there are too few instants for errors",
                               least_instants, scene.run.steps / least_instants));
  require_together(scene.run.sample_every <= scene.run.steps, places, "run.sample_every",
                   scene.run.sample_every,
                   fmt::format("must be <= run.steps = {}, or there is no sample", scene.run.steps));
}

} // namespace mesobridge::workflows
