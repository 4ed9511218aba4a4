#pragma once
#include "fitting/particle_model_file.hpp"
#include "workflows/scene/checks.hpp"

namespace mesobridge::workflows {

/// The rules of DPD and DPDE scenes that concern several keys at once. Throws InputError.
void check_pair_fluid(Scene const& scene, Places const& places);

/// What the file says that particles.model names; nothing where none is named. Throws InputError.
std::optional<fitting::ParticleModel> particle_model_of(Scene const& scene);

/// What of a DPD or DPDE scene follows from its model of a particle: the mass and the name of the potential.
/// Throws InputError for a model in other units, and without any mass.
void take_particle_model(Scene& scene, Places const& places);

/// Turns the paths of tables and models into absolute ones; the files must be there. Throws InputError.
void resolve_pair_files(Scene& scene, std::filesystem::path const& folder, Places const& places);

} // namespace mesobridge::workflows
