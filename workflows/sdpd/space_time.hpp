#pragma once
#include "workflows/report/report.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/store/store.hpp"
#include <optional>

namespace mesobridge::workflows {

/// The profiles of a run one above the other: each quantity of them (the velocity along their axis) by colours
/// over place and time. Nothing where the file holds fewer than eight profiles.
std::optional<Section> space_time_section(Store const& store, Scene const& scene, OutputUnits const& units);

} // namespace mesobridge::workflows
