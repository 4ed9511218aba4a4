#pragma once
#include "workflows/command_page.hpp"

namespace mesobridge::workflows {

/// All commands with their summaries, in lines of at most so many columns.
std::string overview(std::vector<Command> const& commands, std::size_t columns);

/// The commands of a group ("fit"), with summaries and examples; empty when there are none.
std::string group_overview(std::string const& group, std::vector<Command> const& commands,
                           std::size_t columns);

/// A command's arguments and options, with what they allow, their defaults, and an example.
std::string command_help(CommandPage const& page, std::size_t columns);

} // namespace mesobridge::workflows
