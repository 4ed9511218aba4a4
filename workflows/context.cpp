#include "md/error.hpp"
#include "workflows/command.hpp"
#include <iostream>

namespace mesobridge::workflows {

Progress Context::progress(std::string title, double total) const {
  if (reports)
    return Progress(Progress::Style::reports, *reports, std::move(title), total);
  auto const style = options.quiet ? Progress::Style::quiet : Progress::style_of_stderr();
  return Progress(style, std::cerr, std::move(title), total);
}

std::filesystem::path Context::output_directory(std::filesystem::path const& fallback) const {
  auto const directory = options.output.value_or(fallback);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw EnvironmentError(
        fmt::format("cannot create directory '{}': {}", directory.string(), error.message()));
  return directory;
}

std::string Context::command_line() const {
  std::string line = "mesobridge";
  for (auto const& argument : arguments) {
    bool const plain =
        !argument.empty() && argument.find_first_of(" \t\n'\"\\$&|;<>()*?#") == std::string::npos;
    if (plain) {
      line += " " + argument;
      continue;
    }
    line += " '";
    for (char const c : argument)
      line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += "'";
  }
  return line;
}

} // namespace mesobridge::workflows
