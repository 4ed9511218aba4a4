#include "workflows/command_line.hpp"
#include "md/error.hpp"
#include "workflows/common_options.hpp"
#include "workflows/help.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/nearest.hpp"
#include "workflows/processors.hpp"
#include "workflows/ranks.hpp"
#include "workflows/summary.hpp"
#include "workflows/terminal.hpp"
#include "workflows/utf8.hpp"
#include "workflows/version.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_sinks.h>

namespace mesobridge::workflows {

namespace {

using Words = std::vector<std::string>;

Words names_of(std::vector<Command> const& commands) {
  Words names;
  for (auto const& command : commands)
    names.push_back(command.name);
  return names;
}

[[noreturn]] void refuse_unknown_command(Words const& arguments, std::vector<Command> const& commands) {
  auto const& first = arguments.front();
  Words in_group;
  for (auto const& command : commands)
    if (command.name.starts_with(first + " "))
      in_group.push_back(command.name);
  bool const bare_group = !in_group.empty() && (arguments.size() == 1 || arguments[1].starts_with("-"));
  if (bare_group)
    throw InputError(fmt::format("'{0}' needs one of: {1}; `mesobridge {0} --help` explains them", first,
                                 fmt::join(in_group, ", ")));
  auto const two_words = arguments.size() > 1 ? first + " " + arguments[1] : first;
  auto names = names_of(commands);
  auto hint = did_you_mean(two_words, names);
  if (hint.empty())
    hint = did_you_mean(first, names);
  throw InputError(fmt::format("unknown command '{}'{}", in_group.empty() ? first : two_words,
                               hint.empty() ? "; `mesobridge --help` lists them all" : hint));
}

/// The command that the first one or two words name, and how many words its name has.
std::pair<Command const*, std::size_t> find_command(Words const& arguments,
                                                    std::vector<Command> const& commands) {
  for (std::size_t words = std::min<std::size_t>(2, arguments.size()); words >= 1; --words) {
    auto const name = words == 2 ? arguments[0] + " " + arguments[1] : arguments[0];
    auto const found =
        std::find_if(commands.begin(), commands.end(), [&](auto& c) { return c.name == name; });
    if (found != commands.end())
      return {&*found, words};
  }
  refuse_unknown_command(arguments, commands);
}

Words option_names(CLI::App const& app) {
  Words names;
  for (auto const* option : app.get_options())
    for (auto const& name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

void refuse_unknown_words(CLI::App const& app, std::string const& command) {
  for (auto const& word : app.remaining()) {
    auto const bare = word.substr(0, word.find('='));
    if (word.starts_with("-"))
      throw InputError(
          fmt::format("{}: unknown option '{}'{}", command, bare, did_you_mean(bare, option_names(app))));
    throw InputError(fmt::format("{}: unexpected argument '{}'", command, word));
  }
}

/// Who reads has enough, as `head` does: ends as other programs then do, quietly.
void end_by_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
}

void print_text(std::string const& text) {
  std::cout << text << (text.empty() || text.ends_with('\n') ? "" : "\n");
  if (std::cout.flush())
    return;
  if (errno == EPIPE)
    end_by_closed_pipe();
  throw EnvironmentError("cannot write to the standard output (is the disk full?)");
}

/// Parses the words after the command's name; returns false when the user asked for help, which was printed.
bool parse(CLI::App& app, Words words, Command const& command) {
  app.allow_extras();                       // so that a misspelt option gets our message with the nearest one
  std::reverse(words.begin(), words.end()); // CLI11 takes its words from the back
  try {
    app.parse(words);
  } catch (CLI::CallForHelp const&) {
    print_text(command_help(page_of(command, app), columns_of(1)));
    return false;
  } catch (CLI::ParseError const& error) {
    refuse_unknown_words(app, command.name);
    throw InputError(command.name + ": " + error.what());
  }
  refuse_unknown_words(app, command.name);
  return true;
}

bool is_watched() {
  return std::getenv(reports_variable) != nullptr;
}

/// Who watches this process tells what it found.
void print(Result const& result, bool json) {
  if (result.silent || is_watched())
    return;
  print_text(json ? checked_dump(result.json) : result.text);
  if (!result.complaint.empty())
    throw EnvironmentError(result.complaint);
}

/// The way to the process that watches this one; nothing where none does.
std::shared_ptr<std::ostream> open_reports() {
  if (!is_watched())
    return nullptr;
  std::signal(SIGPIPE,
              SIG_IGN); // who watches may die first, and this process still has a checkpoint to write
  return std::make_shared<std::ofstream>(fmt::format("/proc/self/fd/{}", std::getenv(reports_variable)));
}

Context make_context(CommonOptions const& options, Words const& arguments) {
  auto log =
      std::make_shared<spdlog::logger>("mesobridge", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  log->set_pattern("%v");
  log->set_level(options.quiet ? spdlog::level::warn : spdlog::level::info);
  return {.options = options, .arguments = arguments, .log = std::move(log), .reports = open_reports()};
}

/// What help is wanted of: the words after "help", or those before a --help that ask for a whole group.
std::optional<Words> words_after_help(Words const& arguments) {
  auto is_flag = [](std::string const& word) { return word == "--help" || word == "-h"; };
  if (is_flag(arguments[0]) || arguments[0] == "help")
    return Words(arguments.begin() + 1, arguments.end());
  if (arguments.size() == 2 && is_flag(arguments[1]))
    return Words{arguments[0]};
  return std::nullopt;
}

void help(Words const& words, std::vector<Command> const& commands) {
  if (words.empty())
    return print_text(overview(commands, columns_of(1)));
  auto const group = group_overview(words[0], commands, columns_of(1));
  if (words.size() == 1 && !group.empty())
    return print_text(group);
  auto const [command, length] = find_command(words, commands);
  if (length < words.size())
    throw InputError(
        fmt::format("help: unexpected argument '{}' after the command '{}'", words[length], command->name));
  print_text(command_help(page_of(*command), columns_of(1)));
}

void run(Words const& arguments, std::vector<Command> const& commands) {
  require_utf8(arguments);
  if (arguments.empty())
    throw InputError("which command?\n\n" + overview(commands, columns_of(2)));
  if (auto const asked = words_after_help(arguments))
    return help(*asked, commands);
  if (arguments[0] == "--version")
    return print_text(fmt::format("mesobridge {} ({})", version(), git_commit()));
  if (arguments[0].starts_with("-"))
    throw InputError(fmt::format("'{}': the command comes first, its options after it", arguments[0]));

  auto const [command, words] = find_command(arguments, commands);
  CLI::App app;
  CommonOptions options;
  auto const action = declare_all(*command, app, options);
  if (!parse(app, {arguments.begin() + static_cast<std::ptrdiff_t>(words), arguments.end()}, *command))
    return;
  catch_interrupts();
  auto context = make_context(options, arguments);
  if (int const available = available_processors(); options.threads.value_or(1) > available)
    context.log->warn(
        "--threads {}: this process may use {} processor(s) only, and more threads than that wait for "
        "each other",
        *options.threads, available);
  print(action(context), options.json);
}

} // namespace

Failure describe(std::exception_ptr error) {
  try {
    std::rethrow_exception(error);
  } catch (InputError const& e) {
    return {bad_input, e.what()};
  } catch (PhysicsError const& e) {
    return {physical_failure, e.what()};
  } catch (EnvironmentError const& e) {
    return {bad_environment, e.what()};
  } catch (Interrupted const& e) {
    return {interrupted, e.what()};
  } catch (std::bad_alloc const&) {
    return {bad_environment, "not enough memory"};
  } catch (std::length_error const&) {
    return {bad_environment, "not enough memory: more than can be addressed was asked for"};
  } catch (Json::exception const& e) {
    return {bad_environment, fmt::format("a JSON file or text is damaged: {}", e.what())};
  } catch (std::exception const& e) {
    return {bad_environment, fmt::format("unexpected failure: {}", e.what())};
  } catch (...) {
    return {bad_environment, "unexpected failure of unknown kind"};
  }
}

int run_command_line(std::vector<std::string> const& arguments, std::vector<Command> const& commands) {
  try {
    run(arguments, commands);
    return done;
  } catch (AlreadyReported const& failure) {
    return failure.exit_code;
  } catch (...) {
    auto const failure = describe(std::current_exception());
    // Whoever watches this process and stopped it says so itself.
    if (failure.code != interrupted || !is_watched())
      std::cerr << "mesobridge: " << failure.message << std::endl;
    return failure.code;
  }
}

} // namespace mesobridge::workflows
