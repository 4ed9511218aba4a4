#pragma once
#include "workflows/report/report.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/store/store.hpp"
#include <optional>

namespace mesobridge::workflows {

/// Drawings of a run's profiles over place and time by colours, of the quantities (all where none are named:
/// rho, velocity along the axis, P, T_int, progress) that the file holds; `of` names the run in their titles.
/// None where the file holds fewer than eight profiles.
std::vector<std::string> space_time_pictures(Store const& store, Scene const& scene, OutputUnits const& units,
                                             std::string const& of = "",
                                             std::vector<std::string> const& quantities = {});

/// The profiles of a run one above the other: each quantity of them (the velocity along their axis) by
/// colours over place and time. Nothing where the file holds fewer than eight profiles.
std::optional<Section> space_time_section(Store const& store, Scene const& scene, OutputUnits const& units);

} // namespace mesobridge::workflows
