#include "workflows/command_page.hpp"
#include "workflows/common_options.hpp"
#include <CLI/CLI.hpp>
#include <array>
#include <fmt/ranges.h>
#include <sstream>

namespace mesobridge::workflows {
namespace {

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

/// The words of "{quick,standard}"; none of other texts.
std::vector<std::string> words_in(std::string const& checks) {
  std::vector<std::string> words;
  if (!checks.starts_with("{") || !checks.ends_with("}"))
    return words;
  std::istringstream list(checks.substr(1, checks.size() - 2));
  for (std::string word; std::getline(list, word, ',');)
    words.push_back(word);
  return words;
}

/// What CLI11 writes behind the colon: "{quick,standard}" or "INT in [1 - 1000]".
std::string allowed_text(std::string const& checks) {
  if (auto const words = words_in(checks); !words.empty())
    return fmt::format("one of {}", fmt::join(words, ", "));
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

std::string usage_of(Command const& command, CLI::App const& app) {
  std::string text = "mesobridge " + command.name;
  for (auto const* option : app.get_options())
    if (option->get_positional()) {
      auto const name = option_name(*option) + (repeats(*option) ? " ..." : "");
      text += option->get_required() ? " " + name : " [" + name + "]";
    }
  return text + " [OPTIONS]";
}

std::vector<std::string> choices_of(CLI::Option const& option) {
  auto const type = option.get_type_name();
  auto const colon = type.find(':');
  return colon == std::string::npos ? std::vector<std::string>() : words_in(type.substr(colon + 1));
}

OptionPage option_page(CLI::Option const& option) {
  OptionPage page{.title = option_name(option),
                  .value = takes_value(option) ? value_name(option) : "",
                  .meaning = meaning(option),
                  .group = option.get_group(),
                  .choices = choices_of(option),
                  .positional = option.get_positional()};
  if (!page.positional) {
    for (auto const& name : option.get_snames())
      page.names.push_back("-" + name);
    for (auto const& name : option.get_lnames())
      page.names.push_back("--" + name);
  }
  return page;
}

} // namespace

CommandPage page_of(Command const& command, CLI::App const& app) {
  CommandPage page{.name = command.name,
                   .summary = command.summary,
                   .usage = usage_of(command, app),
                   .example = command.example,
                   .description = app.get_description()};
  for (auto const* option : app.get_options())
    page.options.push_back(option_page(*option));
  return page;
}

CommandPage page_of(Command const& command) {
  CLI::App app;
  CommonOptions options;
  declare_all(command, app, options);
  return page_of(command, app);
}

std::vector<CommandPage> pages_of(std::vector<Command> const& commands) {
  std::vector<CommandPage> pages;
  for (auto const& command : commands)
    pages.push_back(page_of(command));
  return pages;
}

} // namespace mesobridge::workflows
