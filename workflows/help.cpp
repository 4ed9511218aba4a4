#include "workflows/help.hpp"
#include "workflows/terminal.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
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

/// CLI11's names of types, as words.
std::string type_word(std::string const& type) {
  constexpr std::array<std::array<char const*, 2>, 9> words{{{"TEXT", "NAME"},
                                                             {"INT", "NUMBER"},
                                                             {"UINT", "NUMBER"},
                                                             {"FLOAT", "NUMBER"},
                                                             {"REAL", "NUMBER"},
                                                             {"BOOLEAN", "yes|no"},
                                                             {"PATH(existing)", "PATH"},
                                                             {"FILE(existing)", "FILE"},
                                                             {"DIR", "FOLDER"}}};
  for (auto const& [raw, word] : words)
    if (type == raw)
      return word;
  return type;
}

/// What CLI11 writes behind the colon: "{quick,standard}" or "INT in [1 - 1000]".
std::string allowed_text(std::string const& checks) {
  if (checks.starts_with("{") && checks.ends_with("}")) {
    std::string list;
    for (char const c : checks.substr(1, checks.size() - 2))
      list += c == ',' ? ", " : std::string(1, c);
    return "one of " + list;
  }
  if (auto const bounds = checks.find(" in ["); bounds != std::string::npos && checks.ends_with("]")) {
    auto const range = checks.substr(bounds + 5, checks.size() - bounds - 6);
    auto const dash = range.find(" - ");
    return dash == std::string::npos ? range : range.substr(0, dash) + " to " + range.substr(dash + 3);
  }
  return {};
}

/// Where the checks begin in a type as CLI11 tells it; LOW:HIGH is all type.
std::size_t end_of_type(std::string const& type) {
  auto const colon = type.find(':');
  return colon != std::string::npos && allowed_text(type.substr(colon + 1)).empty() ? type.size() : colon;
}

bool takes_value(CLI::Option const& option) {
  return option.get_items_expected_max() > 0;
}

bool repeats(CLI::Option const& option) {
  return option.get_items_expected_max() > option.get_type_size_max();
}

std::string value_name(CLI::Option const& option) {
  auto const type = option.get_type_name();
  return type_word(type.substr(0, end_of_type(type)));
}

/// "-o, --output PATH".
std::string option_name(CLI::Option const& option) {
  if (option.get_positional())
    return value_name(option) == "NAME" || value_name(option).empty() ? option.get_name(true)
                                                                      : value_name(option);
  std::string names;
  for (auto const& name : option.get_snames())
    names += (names.empty() ? "-" : ", -") + name;
  for (auto const& name : option.get_lnames())
    names += (names.empty() ? "--" : ", --") + name;
  if (takes_value(option))
    names += " " + value_name(option) + (repeats(option) ? " ..." : "");
  return names;
}

std::string default_text(CLI::Option const& option) {
  auto const value = option.get_default_str();
  bool const told = option.get_description().find("default") != std::string::npos;
  if (told || value.empty() || value == "[]" || !takes_value(option) || option.get_required())
    return {};
  bool const list = value.starts_with("[") && value.ends_with("]");
  return "default " + (list ? value.substr(1, value.size() - 2) : value);
}

/// A sentence begins with a capital; names, which hyphens or commas tell, stay as they are typed.
std::string begun(std::string text) {
  auto const end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  if (end > 0 && !text.empty() && (end == std::string::npos || text[end] == ' ' || text[end] == ':'))
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string meaning(CLI::Option const& option) {
  auto text = begun(option.get_description());
  auto const type = option.get_type_name();
  auto const end = std::min(end_of_type(type), type.size());
  std::vector<std::string> more;
  if (option.get_required() && !option.get_positional())
    more.emplace_back("must be given");
  for (auto const* other : option.get_excludes())
    more.push_back("not with " + other->get_name());
  if (end < type.size())
    more.push_back(allowed_text(type.substr(end + 1)));
  more.push_back(default_text(option));
  for (auto const& part : more)
    if (!part.empty())
      text += "; " + part;
  return text;
}

/// The options of a group, in the order in which they were declared.
std::string options_text(CLI::App const& app, std::string const& group, bool positional,
                         std::size_t columns) {
  std::vector<Entry> entries;
  for (auto const* option : app.get_options())
    if (option->get_group() == group && option->get_positional() == positional)
      entries.push_back({option_name(*option), meaning(*option)});
  return entries.empty() ? "" : listed(entries, columns, room_for_names(columns));
}

std::string usage(Command const& command, CLI::App const& app) {
  std::string text = "Usage: mesobridge " + command.name;
  for (auto const* option : app.get_options())
    if (option->get_positional()) {
      auto const name = option_name(*option) + (repeats(*option) ? " ..." : "");
      text += option->get_required() ? " " + name : " [" + name + "]";
    }
  return text + " [OPTIONS]";
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

std::string command_help(Command const& command, CLI::App const& app, std::size_t columns) {
  columns = readable(columns);
  std::string text =
      wrapped(app.get_description(), columns, 0) + "\n" + wrapped(usage(command, app), columns, 2) + "\n";
  text += titled("Arguments", options_text(app, "Options", true, columns));
  text += titled("Options", options_text(app, "Options", false, columns));
  text += titled("Common options", options_text(app, "Common options", false, columns));
  return text + titled("Example", "  " + command.example + "\n");
}

} // namespace mesobridge::workflows
