#include "md/child_process.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mesobridge::md {
namespace {

/// Only signal-safe calls happen between fork and exec, so everything is prepared before.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (auto& word : words)
    result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

/// Whether a variable describes the MPI world of this very process, in which a child would take itself for a
/// rank.
bool belongs_to_this_world(std::string_view variable) {
  for (std::string_view start : {"PMIX_", "ORTE_", "OMPI_MCA_orte_", "OMPI_MCA_ess", "OMPI_MCA_pmix",
                                 "OMPI_COMM_", "OMPI_APP_", "OMPI_NUM_", "OMPI_UNIVERSE_", "OMPI_FIRST_"})
    if (variable.starts_with(start))
      return true;
  return false;
}

std::string_view name_of(std::string_view variable) {
  return variable.substr(0, variable.find('='));
}

std::vector<std::string> environment_with(std::vector<std::string> const& variables) {
  auto result = variables;
  for (char** inherited = environ; *inherited; ++inherited) {
    std::string_view const name = name_of(*inherited);
    if (!belongs_to_this_world(name) && std::none_of(variables.begin(), variables.end(),
                                                     [&](auto const& own) { return name_of(own) == name; }))
      result.emplace_back(*inherited);
  }
  return result;
}

/// While it lives, SIGINT and SIGTERM wait.
class NoStops {
 public:
  NoStops() {
    sigset_t stops;
    sigemptyset(&stops);
    for (int const signal : {SIGINT, SIGTERM})
      sigaddset(&stops, signal);
    pthread_sigmask(SIG_BLOCK, &stops, &before_);
  }
  ~NoStops() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  NoStops(NoStops const&) = delete;
  NoStops& operator=(NoStops const&) = delete;
  sigset_t const& before() const { return before_; }

 private:
  sigset_t before_;
};

[[noreturn]] void become(std::vector<char*> const& command, std::vector<char*> const& environment,
                         ChildSettings const& settings, pid_t parent, sigset_t const& mask) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) // it died before we had asked to be told
    _exit(not_executed);
  auto const streams = settings.streams.value_or(std::array{open("/dev/null", O_RDONLY | O_CLOEXEC), 1, 2});
  for (int stream = 0; stream < 3; ++stream)
    dup2(streams[std::size_t(stream)], stream);
  if (settings.descriptor)
    fcntl(*settings.descriptor, F_SETFD, 0);
  // A stop that came meanwhile must not be taken by the parent's handlers, which end with this program.
  for (int const signal : {SIGINT, SIGTERM})
    std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  execve(command[0], command.data(), environment.data());
  _exit(not_executed);
}

} // namespace

pid_t start_child(std::vector<std::string> argv, ChildSettings const& settings) {
  require(!argv.empty(), "program to start", "", "must be given");
  auto variables = environment_with(settings.variables);
  auto const command = pointers(argv), environment = pointers(variables);
  NoStops const held;
  auto const mask = settings.signal_mask.value_or(held.before());
  pid_t const parent = getpid(), child = fork();
  if (child < 0)
    throw EnvironmentError(fmt::format("'{}' could not be started: {}", argv[0], std::strerror(errno)));
  if (child == 0)
    become(command, environment, settings, parent, mask);
  return child;
}

std::optional<std::string> program_file(std::string const& name) {
  auto const can_be_executed = [](std::filesystem::path const& file) {
    std::error_code none;
    return access(file.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(file, none);
  };
  if (name.find('/') != name.npos)
    return can_be_executed(name) ? std::optional(name) : std::nullopt;
  char const* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (auto const file = std::filesystem::path(folder) / name; can_be_executed(file))
      return file.string();
  return std::nullopt;
}

int exit_code_of(int wait_status) {
  return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

} // namespace mesobridge::md
