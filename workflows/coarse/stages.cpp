#include "workflows/coarse/stages.hpp"
#include "md/error.hpp"
#include "workflows/farm.hpp"
#include "workflows/json_file.hpp"
#include "workflows/ranks.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <fmt/ranges.h>
#include <span>
#include <utility>

namespace mesobridge::workflows {
namespace {

/// What earlier calls have left: the stages that are done, each with its line and seconds, and the lines of
/// those that were begun after them.
Json read_journal(std::filesystem::path const& file) {
  Json const nothing{{"done", Json::array()}, {"begun", Json::array()}};
  if (!std::filesystem::exists(file))
    return nothing;
  auto journal = read_json(file);
  auto const has = [&](char const* key) { return journal.contains(key) && journal[key].is_array(); };
  return has("done") && has("begun") ? journal : nothing;
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

/// Whether the stage was begun, and has left that from which it can go on.
bool goes_on_from(Stage const& stage, Json const& begun) {
  auto const line = line_of(stage);
  return !stage.begun.empty() && std::filesystem::exists(stage.begun) &&
         std::ranges::any_of(begun, [&](Json const& one) { return one == line; });
}

FarmedRun run_of(Stage const& stage, bool goes_on, Context const& context) {
  FarmedRun run{{"/proc/self/exe"}, 1}; // whatever has become of the program's file
  run.argv.insert(run.argv.end(), stage.words.begin(), stage.words.end());
  if (goes_on)
    run.argv.emplace_back("--resume");
  else
    run.argv.insert(run.argv.end(), stage.afresh.begin(), stage.afresh.end());
  if (auto const threads = context.options.threads;
      threads && std::ranges::find(run.argv, "--threads") == run.argv.end())
    run.argv.insert(run.argv.end(), {"--threads", std::to_string(*threads)});
  run.argv.emplace_back("--quiet");
  return run;
}

/// Makes stages that do not need each other; appends their lines to `done` with the seconds that they took,
/// and whether they went on after an interruption, so that the seconds are not of the whole. Of those that
/// are interrupted, the first that have ended are kept.
void make(std::span<Stage const> stages, Json const& begun, Json& all_done, Context const& context) {
  Json done = Json::array();
  std::vector<FarmedRun> runs;
  for (auto const& stage : stages) {
    bool const goes_on = goes_on_from(stage, begun);
    done.push_back({{"line", line_of(stage)}, {"seconds", -1.0}, {"resumed", goes_on}});
    runs.push_back(run_of(stage, goes_on, context));
    runs.back().ended = [&done, k = done.size() - 1](double seconds) { done[k]["seconds"] = seconds; };
  }
  auto const keep_ended = [&] {
    for (std::size_t k = 0; k < stages.size() && done[k]["seconds"] >= 0; ++k)
      all_done.push_back(done[k]);
  };
  try {
    farm(stages.front().title, std::move(runs), ranks_of(context), context);
  } catch (...) {
    keep_ended();
    throw;
  }
  for (auto const& stage : stages)
    if (!std::filesystem::exists(stage.product))
      throw EnvironmentError(
          fmt::format("'{}' has ended without '{}'", line_of(stage), stage.product.string()));
  keep_ended();
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
  auto const left = read_journal(journal);
  for (auto const& stage : left["done"])
    seconds[stage.value("line", "")] = stage.value("seconds", 0.0);
  return seconds;
}

bool has_resumed(std::filesystem::path const& journal) {
  auto const left = read_journal(journal);
  return std::ranges::any_of(left["done"], [](Json const& stage) { return stage.value("resumed", false); });
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
  if (first < stages.size()) // what comes after them in the journal is then of a later list that begins so
    done.erase(done.begin() + std::ptrdiff_t(first), done.end());
  for (std::size_t end = first; first < stages.size(); first = end) {
    for (end = first + 1; end < stages.size() && stages[end - 1].beside_next;)
      ++end;
    auto const now = std::span(stages).subspan(first, end - first);
    auto const begun = std::exchange(left["begun"], Json::array());
    for (auto const& stage : now)
      left["begun"].push_back(line_of(stage));
    write_summary(journal, left);
    try {
      make(now, begun, done, context);
    } catch (...) {
      write_summary(journal, left);
      throw;
    }
    left["begun"] = Json::array();
  }
  write_summary(journal, left);
}

} // namespace mesobridge::workflows
