#include "md/error.hpp"
#include "workflows/beside/beside_report.hpp"
#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/sdpd/equilibrium_report.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/sdpd/run_text.hpp"
#include "workflows/store/store.hpp"
#include "workflows/summary.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

using Folders = std::vector<std::filesystem::path>;

void require_finished(sdpd::Checkpoint const& checkpoint, Scene const& scene, RunFolder const& folder) {
  auto const done =
      std::max<std::int64_t>(0, static_cast<std::int64_t>(checkpoint.step) - scene.run.equilibrate);
  if (done < scene.run.steps)
    throw InputError(fmt::format("'{}' holds a run that was stopped after {} of {} steps: go on with `run "
                                 "{} -o {} --resume`",
                                 folder.path().string(), done, scene.run.steps, folder.scene().string(),
                                 folder.path().string()));
}

/// The results of a finished run as its own files tell them: not a step is made.
RunResult finished_run(RunFolder const& folder, Context const& context) {
  int const threads = context.options.threads.value_or(available_threads());
  require(folder.has_checkpoint() && std::filesystem::exists(folder.scene()), "RUN", folder.path().string(),
          "holds no checkpoint of `run` with its scene.toml: other commands write their reports again when "
          "they are called with --resume, or as they were");
  auto stored = read_checkpoint(folder.checkpoint());
  auto const scene =
      resumed_scene(load_run(folder.scene(), {}, threads), stored.scene, stored.inputs, folder.checkpoint());
  require_finished(stored.checkpoint, scene, folder);
  return run_scene(scene, {.directory = folder.path(),
                           .threads = threads,
                           .past = past_run(std::move(stored)),
                           .told_again = true});
}

/// The command that made the run.
std::string command_of(RunFolder const& folder) {
  return Store(folder.run_file(), Store::Mode::read).read_text_attribute("provenance", "command");
}

Result again(std::filesystem::path const& path, Context const& context) {
  require(!context.options.output, "--output", context.options.output.value_or("").string(),
          "is for several runs: the report of one stands beside its files");
  RunFolder const folder(path);
  require(std::filesystem::is_directory(path), "RUN", path.string(),
          "must be a folder that `run` has written");
  FolderLock const lock(path, context.command_line());
  auto const done = finished_run(folder, context);
  auto const file = folder.report();
  write_equilibrium_report(file, done, command_of(folder));
  for (auto const& finding : done.findings)
    context.log->warn("warning: {}", finding.text);
  Result result{.json = done.summary};
  result.json["report"] = file.string();
  result.text = run_text(done) + file.string();
  return result;
}

/// The numbers side by side get a folder of their own: they would take the place of a run's.
void refuse_folder_of(std::filesystem::path const& run, std::filesystem::path const& directory) {
  require(!std::filesystem::equivalent(run, directory) && !RunFolder(directory).holds_run(), "--output",
          directory.string(), "must be another folder than that of a run");
}

Result beside(Folders const& folders, Context const& context) {
  std::vector<RunNumbers> runs;
  for (auto const& folder : folders)
    runs.push_back(read_run_numbers(folder));
  auto report = beside_report(runs);
  report.provenance = {.command = context.command_line()};
  for (auto const& folder : folders)
    report.provenance.inputs.emplace_back(folder / "summary.json");
  auto const directory = context.output_directory("out/beside");
  for (auto const& folder : folders)
    refuse_folder_of(folder, directory);
  auto result = with_report(directory, beside_runs_json(runs), report.html());
  result.text = beside_runs_text(runs) + result.text;
  return result;
}

Result report_of(Folders const& folders, Context const& context) {
  return folders.size() == 1 ? again(folders.front(), context) : beside(folders, context);
}

void declare(CLI::App& app, Folders& folders) {
  app.add_option(
         "run", folders,
         "One folder that `run` has written: its report is written again, by the files in it. Several "
         "folders with a summary.json each: their numbers side by side")
      ->required()
      ->type_name("RUN");
}

} // namespace

extern Declaration const report_command = with_options<Folders, declare, report_of>;

} // namespace mesobridge::workflows
