#include "workflows/ranks.hpp"
#include "md/error.hpp"
#include "md/mpi_world.hpp"
#include "md/rank_launcher.hpp"
#include "workflows/command_line.hpp"
#include "workflows/interrupt.hpp"
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace mesobridge::workflows {

int ranks_of(Context const& context) {
  return context.options.ranks.value_or(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
}

bool must_start_ranks(Context const& context) {
  return ranks_of(context) > 1 && !md::already_on_ranks();
}

void yield_when_idle() {
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
}

void run_on_ranks(int ranks, std::vector<std::string> const& words) {
  std::vector<std::string> argv{std::filesystem::read_symlink("/proc/self/exe").string()};
  argv.insert(argv.end(), words.begin(), words.end());
  if (int const code = md::run_on_ranks(ranks, argv); code != 0)
    throw AlreadyReported{code};
}

std::vector<std::string> words_for_ranks(Context const& context) {
  auto words = context.arguments;
  std::erase(words, "--json");
  words.emplace_back("--started-by-ourselves");
  return words;
}

bool work_and_tell(Context const& context, bool started_by_ourselves, std::function<void()> const& work) {
  if (must_start_ranks(context)) {
    run_on_ranks(ranks_of(context), words_for_ranks(context));
    return true;
  }
  work();
  return !started_by_ourselves && md::MpiWorld().is_root();
}

Result told_elsewhere() {
  return {.json = {}, .text = "", .complaint = "", .silent = true};
}

void work_on_ranks(Context const& context, std::vector<std::string> words,
                   std::function<void()> const& work) {
  if (!must_start_ranks(context))
    return work();
  if (context.options.quiet)
    words.emplace_back("--quiet");
  run_on_ranks(ranks_of(context), words);
}

void guard_ranks(std::function<void()> const& work) {
  md::MpiWorld const world;
  interrupts_are_asked_for();
  try {
    work();
  } catch (Interrupted const&) {
    throw; // the work has told the other ranks
  } catch (...) {
    if (world.size() == 1)
      throw;
    auto const failure = describe(std::current_exception());
    std::cerr << "mesobridge: " << failure.message << std::endl;
    world.abort(failure.code);
  }
}

} // namespace mesobridge::workflows
