#pragma once
#include "workflows/progress.hpp"
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

// Declared only: these headers are slow to compile, and few of those who include this one need them.
namespace CLI {
class App;
}
namespace spdlog {
class logger;
}

namespace mesobridge::workflows {

using Json = nlohmann::ordered_json;

/// The options that every command has. Those that were not given stay empty: the command knows the default.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  std::optional<std::filesystem::path> output;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads; ///< >= 1; already what the engine uses where nothing else is said
  std::optional<int> ranks;   ///< >= 1
};

/// What a running command gets from the command line.
struct Context {
  CommonOptions options;
  std::vector<std::string> arguments;    ///< all words after the program's name
  std::shared_ptr<spdlog::logger> log;   ///< to stderr; silent but for warnings with --quiet
  std::shared_ptr<std::ostream> reports; ///< to the process that watches this one, if one does

  Progress progress(std::string title, double total) const;

  /// The directory of -o, or the fallback; created if need be. Throws EnvironmentError.
  std::filesystem::path output_directory(std::filesystem::path const& fallback) const;

  /// The whole command as the user would type it again.
  std::string command_line() const;
};

/// What a command has found: the object that --json prints, and the text that it prints otherwise.
struct Result {
  Json json = Json::object();
  std::string text;
  std::string complaint; ///< not empty: printed on stderr after the result; the exit code is then 4
  bool silent = false;   ///< nothing is printed: another rank does it
};

/// One command of the program.
struct Command {
  using Action = std::function<Result(Context&)>;

  std::string name;    ///< "check", "md lj-grid"
  std::string summary; ///< one line for the list of commands
  std::string example; ///< a line that works when it is pasted
  /// Adds the command's own options to the parser and returns what to do once they are parsed.
  std::function<Action(CLI::App&)> declare;
};

} // namespace mesobridge::workflows
