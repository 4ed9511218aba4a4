#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/nearest.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>

namespace mesobridge::workflows {
namespace {

struct Options {
  std::string name, preset = "quick";
};

Result list_all() {
  Result result;
  for (auto const& known : reproductions()) {
    result.json["reproductions"].push_back({{"name", known.name}, {"shows", known.shows}});
    result.text += fmt::format("{:<12} {}\n", known.name, known.shows);
  }
  return result;
}

Reproduction const& find(std::string const& name) {
  std::vector<std::string> names{"list"};
  for (auto const& known : reproductions()) {
    if (known.name == name)
      return known;
    names.push_back(known.name);
  }
  throw InputError(fmt::format("reproduce '{}': must be one of {}{}", name, fmt::join(names, ", "),
                               did_you_mean(name, names)));
}

Result reproduce(Options const& options, Context const& context) {
  if (options.name == "list")
    return list_all();
  auto const& wanted = find(options.name);
  auto const directory = context.output_directory("out/" + wanted.name);
  FolderLock const lock(directory, context.command_line());
  auto const& common = context.options;
  std::uint64_t const seed = common.seed.value_or(1);
  auto found = wanted.run({.preset = preset_of(options.preset),
                           .directory = directory,
                           .seed = seed,
                           .threads = common.threads.value_or(available_threads())},
                          context);
  constexpr char const* thesis = "Faure 2017"; // which every reproduction is compared with
  if (auto& sources = found.report.sources; std::ranges::find(sources, thesis) == sources.end())
    sources.insert(sources.begin(), thesis);
  found.report.provenance = {context.command_line(), seed, "", {}};
  Result result;
  result.json = {{"name", wanted.name}, {"shows", wanted.shows}, {"preset", options.preset}, {"seed", seed}};
  result.json.update(found.summary);
  write_summary(directory / "summary.json", result.json);
  write_text_file(directory / "report.html", found.report.html());
  result.json["report"] = (directory / "report.html").string();
  result.text = (directory / "report.html").string();
  return result;
}

void declare(CLI::App& app, Options& options) {
  app.add_option("name", options.name, "list, or a name of that list")->required();
  app.add_option("--preset", options.preset, "how long to work: a minute or two, an hour, a day")
      ->check(CLI::IsMember({"quick", "standard", "paper"}));
}

} // namespace

Command reproduce_command() {
  return {.name = "reproduce",
          .summary = "A figure or table of the thesis, ours beside the printed one",
          .example = "mesobridge reproduce table-4.1 --preset quick -o out/table-4.1",
          .declare = with_options(declare, reproduce)};
}

} // namespace mesobridge::workflows
