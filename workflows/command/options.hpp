#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Adds a command's options to the parser and returns what to do once they are parsed.
using Declaration = Command::Action (*)(CLI::App&);

/// The declaration of a command with options of its own: `declare` adds them to the parser, `run` gets what
/// was parsed.
template <class Options, void (*declare)(CLI::App&, Options&), Result (*run)(Options const&, Context const&)>
Command::Action with_options(CLI::App& app) {
  auto options = std::make_shared<Options>();
  declare(app, *options);
  return [options](Context& context) { return run(*options, context); };
}

} // namespace mesobridge::workflows
