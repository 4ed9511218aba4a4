#pragma once
#include "fitting/fit_family.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// The command that fits one kind of equation of state to data files.
Command fit_kind_command(fitting::FittableKind const& kind);

} // namespace mesobridge::workflows
