#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Thrown when another process of this program has failed and told why: only its exit code is passed on.
struct AlreadyReported {
  int exit_code;
};

/// Whether this process has to start a command's ranks: more than one is wanted and none runs yet.
bool must_start_ranks(Context const& context);

/// How many ranks a command runs on: --ranks, or all cores.
int ranks_of(Context const& context);

/// For ranks that are started from now on: one that waits for another leaves it the processor, which they may
/// have to share.
void yield_when_idle();

/// Runs this program again on that many ranks with the given words, which must be such that it prints no
/// result. Throws AlreadyReported if it fails, EnvironmentError if it cannot be started.
void run_on_ranks(int ranks, std::vector<std::string> const& words);

/// The words of this very call for ranks that it starts, whose result it tells itself.
std::vector<std::string> words_for_ranks(Context const& context);

/// Does a command's work on this process's rank, or has it done by this same call on ranks of its own.
/// Whether this process tells the result: another one does where it was started for its rank, and on ranks
/// but the first.
bool work_and_tell(Context const& context, bool started_by_ourselves, std::function<void()> const& work);

/// The result of a process that leaves the telling to another.
Result told_elsewhere();

/// Does the work on this process's rank, or has it done by this program on ranks of its own, called with the
/// words (and --quiet where this call is).
void work_on_ranks(Context const& context, std::vector<std::string> words, std::function<void()> const& work);

/// Runs a part of the work that every rank does. When one rank alone fails, its message is printed and all
/// ranks are ended, since the others would wait for it for ever.
void guard_ranks(std::function<void()> const& work);

} // namespace mesobridge::workflows
