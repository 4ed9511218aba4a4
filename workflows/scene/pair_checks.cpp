#include "workflows/scene/pair_checks.hpp"
#include "md/error.hpp"
#include "sdpd/method/settings.hpp"
#include "workflows/scene/keys/tables.hpp"
#include "workflows/scene/wanted_keys.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

using Part = fitting::PairColumns fitting::ParticleModel::*;

bool model_has(Scene const& scene, Part part) {
  auto const model = particle_model_of(scene);
  return model && !((*model).*part).empty();
}

void check_potential(Scene const& scene, Places const& places) {
  auto const& potential = scene.potential;
  require_together(potential.name != "model" || model_has(scene, &fitting::ParticleModel::potential), places,
                   "potential.name", potential.name, "needs particles.model, a file with a potential");
  auto keys = parameter_keys("potential", potential_parameters(), potential.parameters, sdpd::potentials());
  keys.push_back({"potential.file", potential.file.has_value(), {"table"}});
  check_wanted("potential.name", potential.name, keys, places);
}

void check_friction(Scene const& scene, Places const& places) {
  auto const& f = scene.friction;
  auto refuse = [&](std::string const& key, std::string const& why) {
    throw InputError(fmt::format("{}: key '{}' {}", places.of(key), key, why));
  };
  bool const plain = f.gamma_par && f.cutoff;
  if (f == Scene::Friction{} && model_has(scene, &fitting::ParticleModel::friction))
    return;
  if (!plain && !f.file)
    refuse(f.gamma_par ? "friction.cutoff" : "friction.gamma_par",
           "is missing (or give a table with friction.file)");
  if (f.file && (f.gamma_par || f.cutoff || f.exponent || f.gamma_perp > 0))
    refuse("friction.file",
           "stands in place of gamma_par, gamma_perp, cutoff and exponent: give one or the other");
}

void check_conduction(Scene const& scene, Places const& places) {
  auto const& c = scene.conduction;
  auto refuse = [&](std::string const& key, std::string const& why) {
    throw InputError(fmt::format("{}: key '{}' {}", places.of(key), key, why));
  };
  if (c.file && (c.kappa.value_or(0) > 0 || c.cutoff || c.exponent))
    refuse("conduction.file", "stands in place of kappa, cutoff and exponent: give one or the other");
  if ((c.cutoff || c.exponent) && c.kappa.value_or(0) == 0)
    refuse(c.cutoff ? "conduction.cutoff" : "conduction.exponent",
           "needs conduction.kappa > 0: without it no heat is conducted");
}

void check_internal_energy(Scene const& scene, Places const& places) {
  auto const& [heat_capacity, model] = scene.internal_energy;
  bool const either = heat_capacity || model || scene.particles.model;
  if (scene.features().energies && (!either || (heat_capacity && model)))
    throw InputError(fmt::format("{}: a {} scene needs one of internal_energy.heat_capacity, "
                                 "internal_energy.model and particles.model{}",
                                 places.of("method.name"), scene.method.name,
                                 model ? ", not both of the first two" : ""));
}

void resolve(std::optional<std::string>& file, std::string const& key, std::filesystem::path const& folder,
             Places const& places) {
  if (!file)
    return;
  auto const path = std::filesystem::absolute(folder / *file).lexically_normal();
  require(std::filesystem::is_regular_file(path), places.of(key) + ": " + key, *file,
          fmt::format("there is no file '{}'", path.string()));
  file = path.string();
}

} // namespace

std::optional<fitting::ParticleModel> particle_model_of(Scene const& scene) {
  if (auto const& file = scene.particles.model)
    return fitting::parse_particle_model(read_text_file(*file), *file);
  return std::nullopt;
}

void take_particle_model(Scene& scene, Places const& places) {
  auto const model = particle_model_of(scene);
  auto& mass = scene.particles.mass;
  if (model) {
    bool const reduced = scene.units == UnitSystem::lj;
    require_together(model->reduced == reduced, places, "particles.model", *scene.particles.model,
                     model->reduced ? "its numbers are reduced, but units = \"SI\""
                                    : "its numbers are in SI, but units = \"lj\"");
    mass = mass ? mass : model->mass;
    if (!places.given("conduction.kappa") && !scene.conduction.file)
      scene.conduction.kappa.reset();
    if (!places.given("potential.name") && !model->potential.empty())
      scene.potential.name = "model";
  }
  if (!scene.features().densities && !mass)
    throw InputError(fmt::format("{}: key 'particles.mass' is missing (mass of one particle){}",
                                 places.of("method.name"),
                                 model ? ", which particles.model does not hold" : ""));
}

void check_pair_fluid(Scene const& scene, Places const& places) {
  check_potential(scene, places);
  check_friction(scene, places);
  check_conduction(scene, places);
  check_internal_energy(scene, places);
}

void resolve_pair_files(Scene& scene, std::filesystem::path const& folder, Places const& places) {
  resolve(scene.particles.model, "particles.model", folder, places);
  resolve(scene.potential.file, "potential.file", folder, places);
  resolve(scene.friction.file, "friction.file", folder, places);
  resolve(scene.conduction.file, "conduction.file", folder, places);
  resolve(scene.internal_energy.model, "internal_energy.model", folder, places);
}

} // namespace mesobridge::workflows
