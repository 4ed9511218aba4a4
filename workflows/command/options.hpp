#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// What a command with options of its own returns: `declare` adds them to the parser, `run` gets what was
/// parsed.
template <class Options, class Run>
Command::Action with_options(CLI::App& app, void (*declare)(CLI::App&, Options&), Run run) {
  auto options = std::make_shared<Options>();
  declare(app, *options);
  return [options, run](Context& context) { return run(*options, context); };
}

} // namespace mesobridge::workflows
