#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// One argument or option of a command, in words.
struct OptionPage {
  std::string title;                     ///< "-o, --output PATH", or "SCENE.toml" of an argument
  std::vector<std::string> names = {};   ///< "-o", "--output"; none of an argument
  std::string value;                     ///< "PATH"; empty: a flag
  std::string meaning;                   ///< with what it allows and its default
  std::string group;                     ///< "Options" or "Common options"; empty: not for users
  std::vector<std::string> choices = {}; ///< empty: any value
  bool positional = false;
};

/// All that help, manual pages and the completion of a shell say of a command.
struct CommandPage {
  std::string name, summary;
  std::string usage; ///< "mesobridge run SCENE.toml [OPTIONS]"
  std::string example;
  std::string description = {};         ///< paragraphs, where the summary is not all that there is to say
  std::vector<OptionPage> options = {}; ///< in the order in which they were declared
};

/// Of a command whose options have been declared in `app`.
CommandPage page_of(Command const& command, CLI::App const& app);
CommandPage page_of(Command const& command);
std::vector<CommandPage> pages_of(std::vector<Command> const& commands);

} // namespace mesobridge::workflows
