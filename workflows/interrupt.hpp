#pragma once

namespace mesobridge::workflows {

/// From now on the first signal that asks the program to end does so at once, with the exit code of an
/// interruption: SIGINT, SIGTERM, and those of closing terminals and batch queues (SIGHUP unless it is
/// ignored, as nohup does; SIGXCPU, SIGUSR1). From the first question for it on (see below) it only raises a
/// flag, so that the work can be saved; a second SIGINT or SIGTERM, some seconds later, then ends the program
/// at once too.
void catch_interrupts();

/// To be called first of all: a reader that goes away and a file that may not grow are errors of a write, not
/// the program's end; and where the standard streams are closed, no file of ours takes their place.
void survive_failing_streams();

/// What follows has nothing to save and does not ask: a signal ends it at once again. Throws Interrupted when
/// one has come.
void interrupts_end_at_once();

/// Whether the user asked the program to stop.
bool interrupt_requested();

/// What follows saves its work when it is asked to stop, though its first question may come late or, on ranks
/// whose root asks for all, never: from now on a signal only raises the flag. Throws Interrupted when one has
/// come.
void interrupts_are_asked_for();

/// Throws Interrupted once the user asked the program to stop. Long loops call it where stopping loses
/// nothing.
void throw_if_interrupted();

} // namespace mesobridge::workflows
