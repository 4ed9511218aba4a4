#pragma once

namespace mesobridge::workflows {

/// From now on the first SIGINT or SIGTERM ends the program at once, with the exit code of an interruption.
/// From the first question for it on (see below) it only raises a flag, so that the work can be saved; a
/// second signal, some seconds later, then ends the program at once too.
void catch_interrupts();

/// What follows has nothing to save and does not ask: a signal ends it at once again. Throws Interrupted when
/// one has come.
void interrupts_end_at_once();

/// Whether the user asked the program to stop.
bool interrupt_requested();

/// Throws Interrupted once the user asked the program to stop. Long loops call it where stopping loses
/// nothing.
void throw_if_interrupted();

} // namespace mesobridge::workflows
