#pragma once
#include "workflows/command_page.hpp"

namespace mesobridge::workflows {

/// The shells that completion_script knows: "bash", "zsh", "fish".
std::vector<std::string> const& known_shells();

/// A script by which that shell completes commands, options and, where an option allows certain words only,
/// those; files everywhere else. It is made of the pages alone: nothing is started while somebody types.
/// Throws InputError for another shell.
std::string completion_script(std::string const& shell, std::vector<CommandPage> const& pages);

} // namespace mesobridge::workflows
