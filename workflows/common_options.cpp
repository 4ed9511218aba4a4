#include "workflows/common_options.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {
namespace {

void add_common_options(CLI::App& app, CommonOptions& options) {
  auto const add = [&](std::string const& names, auto& target, std::string const& type,
                       std::string const& text) {
    return app.add_option(names, target, text)->type_name(type)->group("Common options");
  };
  auto const add_flag = [&](std::string const& name, bool& target, std::string const& text) {
    app.add_flag(name, target, text)->group("Common options");
  };
  add_flag("--json", options.json, "Print one JSON object on stdout, everything else on stderr");
  add("-o,--output", options.output, "PATH", "Where to write");
  add("--seed", options.seed, "INT", "Seed of all random numbers")
      ->check(CLI::NonNegativeNumber.description(""));
  add("--threads", options.threads, "INT", "Threads (default: all cores)")
      ->check(CLI::Range(1, 4096).description(""));
  add("--ranks", options.ranks, "INT", "MPI ranks for LAMMPS (default: all cores)")
      ->check(CLI::Range(1, 65536).description(""));
  add_flag("--quiet", options.quiet, "No progress and no messages but warnings");
}

} // namespace

Command::Action declare_all(Command const& command, CLI::App& app, CommonOptions& options) {
  app.option_defaults()->always_capture_default(); // the help shows them
  app.set_help_flag("-h,--help", "Print this and end")->group("Common options");
  auto action = command.declare(app);
  add_common_options(app, options);
  return action;
}

} // namespace mesobridge::workflows
