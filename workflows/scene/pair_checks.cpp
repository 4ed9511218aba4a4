#include "workflows/scene/pair_checks.hpp"
#include "md/error.hpp"
#include "sdpd/method/settings.hpp"
#include "workflows/scene/keys/tables.hpp"
#include "workflows/scene/wanted_keys.hpp"

namespace mesobridge::workflows {
namespace {

void check_potential(Scene const& scene, Places const& places) {
  auto const& potential = scene.potential;
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
  if (c.file && (c.kappa > 0 || c.cutoff || c.exponent))
    refuse("conduction.file", "stands in place of kappa, cutoff and exponent: give one or the other");
  if ((c.cutoff || c.exponent) && c.kappa == 0)
    refuse(c.cutoff ? "conduction.cutoff" : "conduction.exponent",
           "needs conduction.kappa > 0: without it no heat is conducted");
}

void check_internal_energy(Scene const& scene, Places const& places) {
  auto const& [heat_capacity, model] = scene.internal_energy;
  if (scene.features().energies && heat_capacity.has_value() == model.has_value())
    throw InputError(fmt::format("{}: a {} scene needs one of internal_energy.heat_capacity and "
                                 "internal_energy.model{}",
                                 places.of("method.name"), scene.method.name, model ? ", not both" : ""));
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

void check_pair_fluid(Scene const& scene, Places const& places) {
  check_potential(scene, places);
  check_friction(scene, places);
  check_conduction(scene, places);
  check_internal_energy(scene, places);
}

void resolve_pair_files(Scene& scene, std::filesystem::path const& folder, Places const& places) {
  resolve(scene.potential.file, "potential.file", folder, places);
  resolve(scene.friction.file, "friction.file", folder, places);
  resolve(scene.conduction.file, "conduction.file", folder, places);
  resolve(scene.internal_energy.model, "internal_energy.model", folder, places);
}

} // namespace mesobridge::workflows
