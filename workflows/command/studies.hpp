#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// The commands that study schemes and reproduce published results; declared apart from the others since few
/// files need them.
Command reproduce_command();

} // namespace mesobridge::workflows
