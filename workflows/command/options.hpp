#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// What a command with options of its own declares: `declare` adds them to the parser, `run` gets what was
/// parsed.
template <class Options, class Run>
auto with_options(void (*declare)(CLI::App&, Options&), Run run) {
  return [declare, run](CLI::App& app) -> Command::Action {
    auto options = std::make_shared<Options>();
    declare(app, *options);
    return [options, run](Context& context) { return run(*options, context); };
  };
}

} // namespace mesobridge::workflows
