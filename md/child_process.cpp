#include "md/child_process.hpp"
#include "md/error.hpp"
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/prctl.h>
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

std::vector<std::string> environment_with(std::vector<std::string> const& variables) {
  std::vector<std::string> result;
  for (char** variable = environ; *variable; ++variable)
    if (!belongs_to_this_world(*variable))
      result.emplace_back(*variable);
  result.insert(result.end(), variables.begin(), variables.end());
  return result;
}

[[noreturn]] void become(std::vector<char*> const& command, std::vector<char*> const& environment,
                         ChildSettings const& settings) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  int const nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, 0);
  if (settings.descriptor)
    fcntl(*settings.descriptor, F_SETFD, 0);
  if (settings.signal_mask)
    pthread_sigmask(SIG_SETMASK, &*settings.signal_mask, nullptr);
  execve(command[0], command.data(), environment.data());
  _exit(127);
}

} // namespace

pid_t start_child(std::vector<std::string> argv, ChildSettings const& settings) {
  require(!argv.empty(), "program to start", "", "must be given");
  auto variables = environment_with(settings.variables);
  auto const command = pointers(argv), environment = pointers(variables);
  pid_t const child = fork();
  if (child < 0)
    throw EnvironmentError(fmt::format("'{}' could not be started: {}", argv[0], std::strerror(errno)));
  if (child == 0)
    become(command, environment, settings);
  return child;
}

} // namespace mesobridge::md
