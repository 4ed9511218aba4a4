#include "workflows/pages/manual.hpp"
#include "workflows/version.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace mesobridge::workflows {
namespace {

/// As roff shows it: hyphens that may be pasted, no escape and no macro by accident.
std::string roff(std::string const& text) {
  std::string result;
  for (char const c : text)
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return result.starts_with(".") || result.starts_with("'") ? "\\&" + result : result;
}

std::string heading(std::string const& name, std::string const& summary) {
  std::string title = "mesobridge";
  if (!name.empty())
    title += "-" + name;
  std::ranges::replace(title, ' ', '-');
  return fmt::format(".TH \"{}\" 1 \"\" \"mesobridge {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", title,
                     version(), roff(title), roff(summary));
}

std::string entry(std::string const& term, std::string const& text) {
  return fmt::format(".TP\n.B {}\n{}\n", roff(term), roff(text));
}

std::string options_of(CommandPage const& page, std::string const& group, bool positional) {
  std::string text;
  for (auto const& option : page.options)
    if (option.group == group && option.positional == positional)
      text += entry(option.title, option.meaning);
  return text;
}

std::string section(std::string const& title, std::string const& text) {
  return text.empty() ? "" : fmt::format(".SH \"{}\"\n{}", title, text);
}

/// Paragraphs stand between empty lines.
std::string paragraphs(std::string const& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    result += line.empty() ? ".PP\n" : roff(line) + "\n";
  return result;
}

} // namespace

std::string manual_file(CommandPage const& page) {
  auto name = "mesobridge-" + page.name + ".1";
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string manual_page(CommandPage const& page) {
  return heading(page.name, page.summary) + section("SYNOPSIS", ".B " + roff(page.usage) + "\n") +
         section("DESCRIPTION", paragraphs(page.description)) +
         section("ARGUMENTS", options_of(page, "Options", true)) +
         section("OPTIONS", options_of(page, "Options", false)) +
         section("COMMON OPTIONS", options_of(page, "Common options", false)) +
         section("EXAMPLE", ".nf\n" + roff(page.example) + "\n.fi\n") +
         section("SEE ALSO", ".BR mesobridge (1)\n");
}

std::string manual_overview(std::vector<CommandPage> const& pages) {
  std::string commands;
  for (auto const& page : pages)
    commands += entry("mesobridge " + page.name, page.summary);
  return heading("", "from molecular dynamics to mesoscopic models, in one chain") +
         section("SYNOPSIS", ".B mesobridge COMMAND [OPTIONS]\n") +
         section("DESCRIPTION",
                 "Each command has a page of its own, mesobridge\\-COMMAND(1), whose words are "
                 "those of its \\-\\-help; `mesobridge check \\-\\-keys` explains a scene.\n") +
         section("COMMANDS", commands) +
         section("EXIT STATUS", entry("0", "done") + entry("2", "bad input") +
                                    entry("3", "a failure of the physics") +
                                    entry("4", "a failure of the machine") +
                                    entry("130", "interrupted; nothing that had been written is lost"));
}

} // namespace mesobridge::workflows
