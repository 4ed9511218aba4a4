#include "workflows/help.hpp"
#include "workflows/terminal.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// Names and what they mean, in two columns: texts begin at the same place where names leave room for them.
struct Entry {
  std::string name, meaning;
};

std::string listed(std::vector<Entry> const& entries, std::size_t columns, std::size_t widest_name) {
  std::size_t width = 0;
  for (auto const& [name, meaning] : entries)
    if (display_width(name) <= widest_name)
      width = std::max(width, display_width(name));
  constexpr std::size_t margin = 2;
  std::size_t const at = margin + width + 2;
  std::string text;
  for (auto const& [name, meaning] : entries) {
    text += std::string(margin, ' ') + name;
    bool const fits = display_width(name) <= width;
    text += fits ? std::string(at - margin - display_width(name), ' ') : "\n" + std::string(at, ' ');
    text += wrapped(meaning, columns, at) + "\n";
  }
  return text;
}

/// Names may take this part of a line.
std::size_t room_for_names(std::size_t columns) {
  return std::max<std::size_t>(columns * 2 / 5, 16);
}

/// The options of a group, in the order in which they were declared.
std::string options_text(CommandPage const& page, std::string const& group, bool positional,
                         std::size_t columns) {
  std::vector<Entry> entries;
  for (auto const& option : page.options)
    if (option.group == group && option.positional == positional)
      entries.push_back({option.title, option.meaning});
  return entries.empty() ? "" : listed(entries, columns, room_for_names(columns));
}

std::string titled(std::string const& title, std::string const& text) {
  return text.empty() ? "" : "\n" + title + ":\n" + text;
}

std::size_t readable(std::size_t columns) {
  constexpr std::size_t narrowest = 40, widest = 110; // longer lines are hard to read
  return std::clamp(columns, narrowest, widest);
}

} // namespace

std::string overview(std::vector<Command> const& commands, std::size_t columns) {
  columns = readable(columns);
  std::vector<Entry> entries;
  for (auto const& command : commands)
    entries.push_back({command.name, command.summary});
  return wrapped("mesobridge: from molecular dynamics to mesoscopic models, in one chain", columns, 0) +
         "\n\nUsage: mesobridge COMMAND [OPTIONS]\n\nCommands:\n" +
         listed(entries, columns, room_for_names(columns)) + "\n" +
         wrapped("`mesobridge COMMAND --help` (or `mesobridge help COMMAND`) explains a command and shows an "
                 "example; `mesobridge check --keys` explains a scene; `mesobridge --version`.",
                 columns, 0) +
         "\n";
}

std::string group_overview(std::string const& group, std::vector<Command> const& commands,
                           std::size_t columns) {
  columns = readable(columns);
  std::vector<Entry> entries;
  std::string examples;
  for (auto const& command : commands)
    if (command.name.starts_with(group + " ")) {
      entries.push_back({command.name, command.summary});
      examples += "  " + command.example + "\n";
    }
  if (entries.empty())
    return {};
  return fmt::format("Usage: mesobridge {} COMMAND [OPTIONS]\n\nCommands:\n", group) +
         listed(entries, columns, room_for_names(columns)) + titled("Examples", examples) + "\n" +
         wrapped(fmt::format("`mesobridge {} --help` explains one.", entries.front().name), columns, 0) +
         "\n";
}

std::string command_help(CommandPage const& page, std::size_t columns) {
  columns = readable(columns);
  std::string text =
      wrapped(page.description, columns, 0) + "\n" + wrapped("Usage: " + page.usage, columns, 2) + "\n";
  text += titled("Arguments", options_text(page, "Options", true, columns));
  text += titled("Options", options_text(page, "Options", false, columns));
  text += titled("Common options", options_text(page, "Common options", false, columns));
  return text + titled("Example", "  " + page.example + "\n");
}

} // namespace mesobridge::workflows
