#include "workflows/interrupt.hpp"
#include "md/error.hpp"
#include "workflows/progress.hpp"
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

namespace mesobridge::workflows {

namespace {

constexpr int interrupted_code = 130; ///< the exit code of an interruption

// A signal handler can reach nothing but globals: these are the program's only ones.
volatile std::sig_atomic_t signal_received = 0;
volatile std::sig_atomic_t flag_is_read = 0; ///< by the work under way, since its first look
volatile std::sig_atomic_t speaks = 1;       ///< who watches this process speaks for it

volatile std::sig_atomic_t second_received = 0; ///< of a clock that never goes back

std::sig_atomic_t seconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::sig_atomic_t>(now.tv_sec);
}

/// Who looks at the flag saves what has to be saved; everything else has nothing to lose and ends here. Who
/// asks twice at once (timeout(1) signals a program and its group) is not impatient; who asks again later is.
void raise_flag(int signal) {
  constexpr std::sig_atomic_t same_wish = 1;
  bool const repeats_itself = signal == SIGHUP || signal == SIGXCPU || signal == SIGUSR1; // from the system
  bool const again = !repeats_itself && signal_received != 0 && seconds() - second_received > same_wish;
  if (signal_received == 0)
    second_received = seconds();
  signal_received = signal;
  if (flag_is_read && !again)
    return;
  constexpr std::string_view message = "mesobridge: interrupted; what was written stays\n";
  [[maybe_unused]] auto const written = speaks ? write(STDERR_FILENO, message.data(), message.size()) : 0;
  _exit(interrupted_code);
}

void handle(int signal) {
  struct sigaction action {};
  action.sa_handler = raise_flag;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

void catch_interrupts() {
  signal_received = 0;
  flag_is_read = 0;
  speaks = std::getenv(reports_variable) == nullptr;
  for (int const signal : {SIGINT, SIGTERM, SIGXCPU, SIGUSR1})
    handle(signal);
  if (!is_ignored(SIGHUP))
    handle(SIGHUP);
}

void survive_failing_streams() {
  for (int const signal : {SIGPIPE, SIGXFSZ}) // the write that fails says why
    std::signal(signal, SIG_IGN);
  for (int const descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    while (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF && open("/dev/null", O_RDWR) >= 0) {
      // open takes the lowest number that is free
    }
}

bool interrupt_requested() {
  flag_is_read = 1;
  return signal_received != 0;
}

void interrupts_end_at_once() {
  throw_if_interrupted();
  flag_is_read = 0;
}

void interrupts_are_asked_for() {
  throw_if_interrupted();
}

void throw_if_interrupted() {
  if (!interrupt_requested())
    return;
  throw Interrupted(signal_received == SIGINT ? "interrupted; what was written stays"
                                              : fmt::format("interrupted by SIG{}; what was written stays",
                                                            sigabbrev_np(signal_received)));
}

} // namespace mesobridge::workflows
