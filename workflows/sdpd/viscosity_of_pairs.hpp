#pragma once
#include "sdpd/setup/realised_viscosity.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// Whether the viscosity of the pairs' friction is still to be found by trials.
bool wants_trials_of_viscosity(Scene const& scene);

/// The fluid of those trials: that of [fluid] with the same particles, scheme and time step; its viscosity is
/// the one that is asked for.
sdpd::SimulationSettings settings_of_viscosity_trials(Scene const& scene, int threads);

/// Throws InputError where no trial is needed to see that it does not exist.
void check_viscosity_trials(Scene const& scene);

/// Finds it on the scene's own fluid, whose densities are known. Throws as realise_viscosity, with the keys
/// that ask for it. `tell` gets a line for each trial that is done, if given.
sdpd::RealisedViscosity find_viscosity_of_pairs(Scene const& scene, int threads,
                                                std::function<bool()> const& keep_going,
                                                std::function<void(std::string const&)> const& tell);

/// eta_pairs, eta_realised and how they were found, in the scene's units.
Json viscosity_trials_json(sdpd::RealisedViscosity const& found, Scene const& scene);

/// Puts the viscosities of a run with eta_means = "realised" into its summary: asked for, of the pairs, and
/// realised by the trials, which are null where the scene has given eta_pairs itself.
void put_viscosities(Json& summary, Scene const& scene, Json const& trials);

/// The same in words, of that summary: "2.01 ± 0.02 Pa s at 16 spacings (asked: ...)"; nothing of other
/// scenes.
std::string viscosities_text(Scene const& scene, Json const& summary);

/// What `check` says of the trials to come, and of viscosities that a fluid can hardly have.
std::string plan_of_viscosity_trials(Scene const& scene);

} // namespace mesobridge::workflows
