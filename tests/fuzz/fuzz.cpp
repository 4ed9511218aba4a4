#include "fuzz/child.hpp"
#include "fuzz/judge.hpp"
#include "scratch_directory.hpp"
#include "workflows/command/list.hpp"
#include "workflows/command_line.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iostream>
#include <map>

// Gives the program damaged, contradictory and strange inputs, thousands of them, and looks at how it ends:
//   fuzz --kind h5md --count 1000 --seed 1 --keep folder-for-those-that-fail
// Every trial is a function of kind, seed and number, so that one can be made again with --first N --count 1.
// Meant for a build with the address and undefined-behaviour sanitizers (tests/fuzz/run.sh).

namespace mesobridge::fuzz {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> kinds;
  std::size_t first = 0, count = 100;
  std::uint64_t seed = 1;
  fs::path keep;
};

struct Tally {
  std::map<int, std::size_t> by_status;
  std::size_t faults = 0;
};

std::uint64_t seed_of(Kind const& kind, std::uint64_t seed, std::size_t number) {
  std::seed_seq sequence(kind.name.begin(), kind.name.end());
  std::array<std::uint32_t, 2> word{};
  sequence.generate(word.begin(), word.end());
  return (std::uint64_t{word[0]} << 32 | word[1]) ^
         (seed * 0x9e3779b97f4a7c15u + number * 0xbf58476d1ce4e5b9u);
}

std::vector<Outcome> outcomes_of(Trial const& trial) {
  std::vector<Outcome> outcomes;
  for (auto const& words : trial.commands) {
    outcomes.push_back(run_in_child(trial.folder, words));
    if (outcomes.size() < trial.commands.size() && !trial.goes_on(outcomes.back()))
      break;
  }
  return outcomes;
}

void tell(Options const& options, Kind const& kind, std::size_t number, Trial const& trial,
          std::vector<Outcome> const& outcomes, std::string const& fault) {
  std::string text = fmt::format("{} {}: {}\n  change: {}\n", kind.name, number, fault, trial.change);
  for (std::size_t k = 0; k < outcomes.size(); ++k)
    text += fmt::format("  mesobridge {}: {}\n{}\n", fmt::join(trial.commands[k], " "), outcomes[k].status,
                        outcomes[k].printed.substr(0, 1500));
  std::cout << text << std::flush;
  if (options.keep.empty())
    return;
  auto const place = options.keep / fmt::format("{}-{}-{}", kind.name, options.seed, number);
  fs::create_directories(options.keep);
  fs::remove_all(place);
  fs::copy(trial.folder, place, fs::copy_options::recursive);
  workflows::write_text_file(place / "what.txt", text);
}

Tally run(Options const& options, Kind const& kind, fs::path const& scratch) {
  auto const original = scratch / kind.name / "original", folder = scratch / kind.name / "trial";
  fs::create_directories(original);
  kind.prepare(original);
  Tally tally;
  for (std::size_t number = options.first; number < options.first + options.count; ++number) {
    fs::remove_all(folder);
    fs::copy(original, folder, fs::copy_options::recursive);
    Random random(seed_of(kind, options.seed, number));
    Trial trial{.folder = folder, .commands = {}, .change = {}};
    kind.change(random, trial);
    auto const outcomes = outcomes_of(trial);
    ++tally.by_status[outcomes.back().status];
    if (auto const fault = fault_of(trial, outcomes); !fault.empty()) {
      ++tally.faults;
      tell(options, kind, number, trial, outcomes, fault);
    }
  }
  fs::remove_all(scratch / kind.name);
  return tally;
}

Options options_of(int argc, char** argv, CLI::App& app) {
  Options options;
  app.add_option("--kind", options.kinds, "Kinds of inputs (default: all)");
  app.add_option("--first", options.first, "Number of the first trial of each kind");
  app.add_option("--count", options.count, "Trials of each kind");
  app.add_option("--seed", options.seed, "Seed of all trials");
  app.add_option("--keep", options.keep, "Folder for the inputs of trials that fail");
  app.parse(argc, argv);
  return options;
}

} // namespace
} // namespace mesobridge::fuzz

int main(int argc, char** argv) {
  using namespace mesobridge::fuzz;
  // A command under test that starts ranks starts this program again.
  std::vector<std::string> const words(argv + 1, argv + argc);
  if (std::ranges::find(words, "--started-by-ourselves") != words.end())
    return mesobridge::workflows::run_command_line(words, mesobridge::workflows::commands());
  CLI::App app("Damaged, contradictory and strange inputs, and how the program ends");
  Options options;
  try {
    options = options_of(argc, argv, app);
  } catch (CLI::ParseError const& error) {
    return app.exit(error);
  }
  mesobridge::tests::ScratchDirectory const scratch;
  std::size_t passed = 0, failed = 0;
  for (auto const& kind : kinds()) {
    if (!options.kinds.empty() && std::ranges::find(options.kinds, kind.name) == options.kinds.end())
      continue;
    auto const tally = run(options, kind, scratch.path());
    std::cout << fmt::format("{}: {} trials, by exit status {}, {} faults\n", kind.name, options.count,
                             tally.by_status, tally.faults)
              << std::flush;
    passed += options.count - tally.faults, failed += tally.faults;
  }
  std::cout << fmt::format("{} passed, {} failed\n", passed, failed);
  return failed == 0 && passed > 0 ? 0 : 1;
}
