#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Adds a command's own options and those that every command has to the parser; returns what to do once they
/// are parsed into `options` and the command's own.
Command::Action declare_all(Command const& command, CLI::App& app, CommonOptions& options);

} // namespace mesobridge::workflows
