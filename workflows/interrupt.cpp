#include "workflows/interrupt.hpp"
#include "md/error.hpp"
#include <csignal>

namespace mesobridge::workflows {

namespace {

// A signal handler can reach nothing but a global: this is the program's only one.
volatile std::sig_atomic_t signal_received = 0;

void raise_flag(int signal) {
  signal_received = signal;
}

} // namespace

void catch_interrupts() {
  signal_received = 0;
  struct sigaction action {};
  action.sa_handler = raise_flag;
  action.sa_flags = SA_RESTART | SA_RESETHAND; // the next signal finds the default again
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupt_requested() {
  return signal_received != 0;
}

void throw_if_interrupted() {
  if (interrupt_requested())
    throw Interrupted(signal_received == SIGTERM ? "interrupted by SIGTERM; what was written stays"
                                                 : "interrupted; what was written stays");
}

} // namespace mesobridge::workflows
