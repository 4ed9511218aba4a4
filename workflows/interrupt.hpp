#pragma once

namespace mesobridge::workflows {

/// From now on the first SIGINT or SIGTERM only raises a flag; a second one ends the program as usual.
void catch_interrupts();

/// Whether the user asked the program to stop.
bool interrupt_requested();

/// Throws Interrupted once the user asked the program to stop. Long loops call it where stopping loses
/// nothing.
void throw_if_interrupted();

} // namespace mesobridge::workflows
