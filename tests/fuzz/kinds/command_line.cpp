#include "fuzz/change_text.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "fuzz/kinds/tiny_run.hpp"
#include "workflows/command/list.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>
#include <fmt/ranges.h>
#include <sstream>

// Words in any order after any command: options of that command with odd values, files that are something
// else.

namespace mesobridge::fuzz {
namespace {

void prepare(std::filesystem::path const& folder) {
  workflows::write_text_file(folder / "scene.toml", tiny_scene);
  workflows::write_text_file(folder / "empty", "");
  workflows::write_text_file(folder / "data.csv", "a,b\n1,2\n");
  std::filesystem::create_directories(folder / "folder.h5");
}

std::vector<std::string> options_of(workflows::Command const& command) {
  CLI::App app;
  command.declare(app);
  std::vector<std::string> names{"--json", "--quiet", "-o", "--seed", "--threads", "--ranks", "--help"};
  for (auto const* option : app.get_options())
    for (auto const& name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

/// Whether it would start other programs or MPI, which work outside this process.
bool starts_others(std::string const& name) {
  return name.starts_with("md ") || name.starts_with("workflow ") || name == "reproduce" ||
         name.starts_with("bench ");
}

void change(Random& random, Trial& trial) {
  static std::vector<std::string> const values{"scene.toml", "empty", "data.csv",  "folder.h5", "missing",
                                               "argon",      "out",   "",          "-",         "--",
                                               "ü",          "%s%n",  "*",         "a=b",       "x=1",
                                               ":",          "1:2",   "published", "/dev/null"};
  static auto const commands = workflows::commands();
  auto const& command = random.of(commands);
  std::vector<std::string> words;
  std::istringstream name(command.name);
  for (std::string word; name >> word;)
    words.push_back(word);
  auto const options = options_of(command);
  for (std::size_t k = random.below(7); k > 0; --k)
    switch (random.below(3)) {
    case 0:
      words.push_back(random.of(options));
      break;
    case 1:
      words.push_back(odd_number(random));
      break;
    default:
      words.push_back(random.of(values));
      break;
    }
  if (starts_others(command.name))
    words.push_back("--no-such-option"); // refused before anything begins
  trial.commands = {words};
  trial.change = fmt::format("{}", fmt::join(words, " "));
}

} // namespace

Kind command_line_kind() {
  return {.name = "command-line", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
