#include "md/rank_launcher.hpp"
#include "md/child_process.hpp"
#include "md/error.hpp"
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mesobridge::md {
namespace {

constexpr char const* terminal_variable = "MESOBRIDGE_TERMINAL";

std::string find_mpirun() {
  if (auto const file = program_file("mpirun"))
    return *file;
  throw EnvironmentError("'mpirun' was not found: install the package openmpi-bin, or run on one rank");
}

std::vector<std::string> mpirun_command(std::string const& mpirun, int ranks,
                                        std::vector<std::string> const& argv) {
  std::vector<std::string> command{mpirun, "--quiet", "-n", std::to_string(ranks), "--oversubscribe"};
  // One machine, no network: neither remote shells nor interfaces are looked for. After an abort mpirun waits
  // twice for the time to SIGKILL, whether or not a rank is left, so it is short.
  for (char const* option : {"--bind-to", "none", "--mca", "plm", "isolated", "--mca", "btl", "self,vader",
                             "--mca", "odls_base_sigkill_timeout", "1"})
    command.emplace_back(option);
  command.insert(command.end(), argv.begin(), argv.end());
  return command;
}

std::vector<std::string> variables_for_ranks() {
  std::vector<std::string> result;
  if (geteuid() == 0) { // Open MPI asks root twice
    result.emplace_back("OMPI_ALLOW_RUN_AS_ROOT=1");
    result.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1");
  }
  std::string terminals;
  for (int descriptor : {1, 2})
    terminals += isatty(descriptor) ? std::to_string(descriptor) : "";
  result.push_back(fmt::format("{}={}", terminal_variable, terminals));
  if (winsize size{}; ioctl(2, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    result.push_back(fmt::format("COLUMNS={}", size.ws_col));
  return result;
}

/// Ranks meet in files of shared memory, and end without a word where these must not grow.
void require_room_for_shared_files() {
  constexpr rlim_t needed = 8 << 20;
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur < needed)
    throw EnvironmentError(fmt::format("MPI ranks share files of up to {} MB, and the limit of file sizes "
                                       "(ulimit -f) is {} kB: raise it, or run on one rank (--ranks 1)",
                                       needed >> 20, limit.rlim_cur / 1024));
}

/// While it lives, SIGINT and SIGTERM wait to be collected instead of ending this process.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&held_);
    for (int signal : {SIGINT, SIGTERM, SIGCHLD})
      sigaddset(&held_, signal);
    pthread_sigmask(SIG_BLOCK, &held_, &before_);
  }
  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(HeldSignals const&) = delete;
  HeldSignals& operator=(HeldSignals const&) = delete;

  /// The next signal, or 0 when none has come for a quarter of a second.
  int wait() const {
    timespec const patience{.tv_sec = 0, .tv_nsec = 250'000'000};
    int const signal = sigtimedwait(&held_, nullptr, &patience);
    return signal > 0 ? signal : 0;
  }
  sigset_t const& before() const { return before_; }

 private:
  sigset_t held_, before_;
};

/// Signals the ranks themselves, mpirun's children. mpirun would follow an interrupt of its own by a kill
/// within a second, too soon for a checkpoint.
void signal_ranks(pid_t mpirun, int signal) {
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", mpirun));
  for (pid_t rank = 0; children >> rank;)
    kill(rank, signal);
}

/// Waits for mpirun, handing on interrupts; returns its wait status and whether there were any.
std::pair<int, bool> wait_for(pid_t mpirun, HeldSignals const& signals) {
  using Clock = std::chrono::steady_clock;
  // Who asks twice at once (timeout(1) signals a program and its group) is not impatient.
  constexpr std::chrono::seconds grace{10}, same_wish{1};
  std::optional<Clock::time_point> interrupted;
  int status = 0;
  for (pid_t ended = 0; (ended = waitpid(mpirun, &status, WNOHANG)) != mpirun;) {
    if (ended < 0 && errno != EINTR)
      throw EnvironmentError(fmt::format("mpirun was lost: {}", std::strerror(errno)));
    int const signal = signals.wait();
    bool const asked_to_stop = signal == SIGINT || signal == SIGTERM;
    if (asked_to_stop && !interrupted) {
      interrupted = Clock::now();
      signal_ranks(mpirun, signal);
    } else if (interrupted && Clock::now() - *interrupted > (asked_to_stop ? same_wish : grace)) {
      kill(mpirun, SIGTERM);
      interrupted = Clock::time_point::max(); // said once
    }
  }
  return {status, interrupted.has_value()};
}

} // namespace

bool already_on_ranks() {
  for (char const* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"})
    if (std::getenv(variable))
      return true;
  // A program without mpirun gets a PMIX_RANK too once MPI has started in it.
  char const* const start = std::getenv("OMPI_MCA_ess");
  return std::getenv("PMIX_RANK") && !(start && std::string_view(start) == "singleton");
}

bool reaches_terminal(int descriptor) {
  if (char const* const terminals = std::getenv(terminal_variable))
    return std::strstr(terminals, std::to_string(descriptor).c_str()) != nullptr;
  return isatty(descriptor) != 0;
}

int run_on_ranks(int ranks, std::vector<std::string> const& argv) {
  require(ranks >= 1, "ranks", ranks, "must be at least 1");
  require(!argv.empty(), "program to start on ranks", "", "must be given");
  auto const command = mpirun_command(find_mpirun(), ranks, argv);
  require_room_for_shared_files();
  HeldSignals const signals;
  pid_t const child = start_child(
      command,
      {.variables = variables_for_ranks(), .descriptor = std::nullopt, .signal_mask = signals.before()});

  auto const [status, interrupted] = wait_for(child, signals);
  if (interrupted)
    return 130;
  int const code = exit_code_of(status);
  if (code == 128 + SIGXFSZ)
    throw EnvironmentError("a file has come to the limit of file sizes (ulimit -f)");
  return code;
}

} // namespace mesobridge::md
