#pragma once
#include <string>
#include <vector>

namespace mesobridge::md {

/// True when this process is already one of several that mpirun, srun or the like has started.
bool already_on_ranks();

/// Runs a program on that many MPI ranks of this machine (by mpirun) and waits for it. SIGINT and SIGTERM are
/// passed on to the ranks, which then have 10 s to end; a second one ends them at once. Standard output and
/// error are those of this process; standard input is empty. Returns the exit code that the program ended
/// with, 130 when it was interrupted. argv[0] is the program. Throws EnvironmentError when mpirun is missing,
/// InputError for ranks < 1 or an empty argv.
int run_on_ranks(int ranks, std::vector<std::string> const& argv);

/// Whether what is written there reaches a terminal (1: standard output, 2: standard error). On ranks that
/// run_on_ranks has started this tells of the launcher's, since mpirun puts pipes and pseudo-terminals in
/// between.
bool reaches_terminal(int descriptor);

} // namespace mesobridge::md
