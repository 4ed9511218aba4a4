#include "workflows/coarse/stages.hpp"
#include "md/error.hpp"
#include "workflows/farm.hpp"
#include "workflows/json_file.hpp"
#include "workflows/summary.hpp"
#include <chrono>
#include <fmt/ranges.h>

namespace mesobridge::workflows {
namespace {

/// What earlier calls have left: the stages that are done, each with its line and seconds, and the line of
/// the one that was begun.
Json read_journal(std::filesystem::path const& file) {
  Json const nothing{{"done", Json::array()}, {"begun", ""}};
  if (!std::filesystem::exists(file))
    return nothing;
  auto journal = read_json(file);
  return journal.contains("done") && journal["done"].is_array() && journal.contains("begun") ? journal
                                                                                             : nothing;
}

std::string quoted_word(std::string const& word) {
  bool const plain =
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=+-") ==
      std::string::npos;
  if (plain && !word.empty())
    return word;
  std::string text = "'";
  for (char const letter : word)
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

void make(Stage const& stage, bool goes_on, Context const& context) {
  FarmedRun run{{"/proc/self/exe"}, 1}; // whatever has become of the program's file
  run.argv.insert(run.argv.end(), stage.words.begin(), stage.words.end());
  if (goes_on && !stage.begun.empty() && std::filesystem::exists(stage.begun))
    run.argv.emplace_back("--resume");
  else
    run.argv.insert(run.argv.end(), stage.afresh.begin(), stage.afresh.end());
  run.argv.emplace_back("--quiet");
  farm(stage.title, {run}, 1, context);
  if (!std::filesystem::exists(stage.product))
    throw EnvironmentError(
        fmt::format("'{}' has ended without '{}'", line_of(stage), stage.product.string()));
}

} // namespace

std::string line_of(Stage const& stage) {
  std::string line = "mesobridge";
  for (auto const& word : stage.words)
    line += " " + quoted_word(word);
  return line;
}

std::map<std::string, double> stage_seconds(std::filesystem::path const& journal) {
  std::map<std::string, double> seconds;
  for (auto const& stage : read_journal(journal)["done"])
    seconds[stage.value("line", "")] = stage.value("seconds", 0.0);
  return seconds;
}

void make_stages(std::vector<Stage> const& stages, std::filesystem::path const& journal,
                 Context const& context) {
  auto left = read_journal(journal);
  auto& done = left["done"];
  std::size_t first = 0;
  while (first < stages.size() && first < done.size() &&
         done[first].value("line", "") == line_of(stages[first]) &&
         std::filesystem::exists(stages[first].product))
    ++first;
  done.erase(done.begin() + std::ptrdiff_t(first), done.end());
  for (std::size_t k = first; k < stages.size(); ++k) {
    auto const line = line_of(stages[k]);
    bool const goes_on = left["begun"] == line;
    left["begun"] = line;
    write_summary(journal, left);
    auto const start = std::chrono::steady_clock::now();
    make(stages[k], goes_on, context);
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    done.push_back({{"line", line}, {"seconds", seconds}}), left["begun"] = "";
  }
  write_summary(journal, left);
}

} // namespace mesobridge::workflows
