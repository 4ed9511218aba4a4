#pragma once
#include "workflows/scene/scene.hpp"
#include "workflows/study/trade_off.hpp"

namespace mesobridge::workflows {

/// Reads "1e-6/ps" (in Lennard-Jones scenes a plain number per unit of time) as a rate per second (per
/// Lennard-Jones unit of time), > 0. Throws InputError that says what is allowed; the caller names the key.
double parse_rate(std::string const& text, UnitSystem units);

/// Reads "0.5%" or "0.005", > 0 and < 1. Throws InputError that says what is allowed.
double parse_share(std::string const& text);

/// The target of these texts for particles whose reduced unit of time is `time` (s, or Lennard-Jones units).
Target parse_target(std::optional<std::string> const& drift, std::optional<std::string> const& bias,
                    UnitSystem units, double time);

} // namespace mesobridge::workflows
