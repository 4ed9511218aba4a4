#pragma once
#include "workflows/scene/scene.hpp"
#include "workflows/study/trade_off.hpp"

namespace mesobridge::workflows {

/// The target of these texts for particles whose reduced unit of time is `time` (s, or Lennard-Jones units),
/// written as scenes write them.
Target parse_target(std::optional<std::string> const& drift, std::optional<std::string> const& bias,
                    std::optional<std::string> const& dynamics, UnitSystem units, double time);

} // namespace mesobridge::workflows
