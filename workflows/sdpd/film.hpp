#pragma once
#include "workflows/report/film_strip.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/store/store.hpp"
#include <filesystem>
#include <optional>

namespace mesobridge::workflows {

/// The film in a run's file, in the units of its drawings; nothing where the scene asks for none or there is
/// no particle in its slab.
std::optional<FilmStrip> film_of(Store const& store, Scene const& scene,
                                 sdpd::SimulationSettings const& settings);

/// At most twelve frames of it.
std::optional<Section> film_section(Store const& store, Scene const& scene,
                                    sdpd::SimulationSettings const& settings);

/// Writes each frame as frame-0001.png ... into a new folder `frames` of the run's; what an earlier call
/// wrote there is replaced. Returns their number, 0 where the scene has no film.
std::size_t write_film_frames(std::filesystem::path const& run_folder, Scene const& scene,
                              sdpd::SimulationSettings const& settings);

} // namespace mesobridge::workflows
