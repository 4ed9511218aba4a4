#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/nearest.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

struct ReproduceCommandOptions {
  std::string name, preset = "quick";
  std::optional<std::string> fit;
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

Result reproduce(ReproduceCommandOptions const& options, Context const& context) {
  if (options.name == "list")
    return list_all();
  auto const& wanted = find(options.name);
  require(!options.fit || wanted.takes_fit, "--fit", options.fit.value_or(""),
          "belongs to table-5.2, figure-5.5 and figure-5.6");
  auto const directory = context.output_directory("out/" + wanted.name);
  FolderLock const lock(directory, context.command_line());
  auto const& common = context.options;
  std::uint64_t const seed = common.seed.value_or(1);
  auto found = wanted.run({.preset = preset_of(options.preset),
                           .directory = directory,
                           .seed = seed,
                           .threads = common.threads.value_or(available_threads()),
                           .fit = options.fit},
                          context);
  constexpr char const* thesis = "Faure 2017"; // which every reproduction is compared with
  if (auto& sources = found.report.sources; std::ranges::find(sources, thesis) == sources.end())
    sources.insert(sources.begin(), thesis);
  found.report.provenance = {context.command_line(), seed, "", {}};
  if (options.fit)
    found.report.provenance.inputs.emplace_back(*options.fit);
  Json summary = {{"name", wanted.name}, {"shows", wanted.shows}, {"preset", options.preset}, {"seed", seed}};
  summary.update(found.summary);
  return with_report(directory, std::move(summary), found.report.html());
}

void declare(CLI::App& app, ReproduceCommandOptions& options) {
  app.add_option("name", options.name, "list, or a name of that list")->required();
  add_preset(app, options.preset, "how long to work: minutes, an hour, a day");
  app.add_option("--fit", options.fit,
                 "Of table-5.2: a file of `fit lj-bwr` (lj-bwr.toml of `workflow lj-to-sdpd`), one more "
                 "equation of state beside the published ones")
      ->type_name("FILE");
}

} // namespace

extern Declaration const reproduce_command = with_options<ReproduceCommandOptions, declare, reproduce>;

} // namespace mesobridge::workflows
