#pragma once
#include "sdpd/system/sub_step.hpp"

namespace mesobridge::sdpd {

/// Makes a sub-step. Throws std::logic_error, which names it, the quantity and by how much, when something
/// has changed that it says it conserves. What is not finite is not judged: that is a failure of another
/// kind.
void run_and_check(SubStep const& sub_step, System& system);

} // namespace mesobridge::sdpd
