#pragma once
#include "workflows/command_page.hpp"

namespace mesobridge::workflows {

/// The manual page of a command, mesobridge-run.1 and so on, as roff with the macros of man(7).
std::string manual_page(CommandPage const& page);

/// mesobridge.1: what the program is, and all its commands.
std::string manual_overview(std::vector<CommandPage> const& pages);

/// "mesobridge-md-lj-grid.1".
std::string manual_file(CommandPage const& page);

} // namespace mesobridge::workflows
