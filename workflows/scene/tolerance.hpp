#pragma once
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// Reads "1e-6/ps" (in Lennard-Jones scenes a plain number per unit of time) as a rate per second (per
/// Lennard-Jones unit of time), > 0. Throws InputError that says what is allowed; the caller names the key.
double parse_rate(std::string const& text, UnitSystem units);

/// Reads "0.5%" or "0.005", > 0 and < 1. Throws InputError that says what is allowed.
double parse_share(std::string const& text);

/// The share of the energy turned over that a driven scene may miss, where its drift is given in per cent;
/// nothing where it is a rate. Throws InputError as parse_share.
std::optional<double> balance_tolerance(Scene::Scheme const& scheme);

/// What errors a scene tolerates of its automatic time step in one line: "drift 1e-6/ps, bias 0.5%, dynamics
/// 5%".
std::string tolerance_text(Scene::Scheme const& scheme);

} // namespace mesobridge::workflows
