#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/lj_to_sdpd/chain.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {
namespace {

struct Options {
  std::string preset = "quick";
};

Result lj_to_sdpd(Options const& options, Context const& context) {
  auto const directory = context.output_directory("out/lj-to-sdpd");
  FolderLock const lock(directory, context.command_line());
  auto const results = run_chain(preset_of(options.preset), options.preset, directory, context);
  Provenance const provenance{context.command_line(),
                              context.options.seed.value_or(1),
                              "",
                              {directory / "md" / "lj-grid.h5", directory / "lj-bwr.toml"}};
  Result result;
  result.json = chain_summary(results);
  write_summary(directory / "summary.json", result.json);
  write_text_file(directory / "report.html", chain_report(results, provenance));
  result.json["report"] = (directory / "report.html").string();
  result.text = (directory / "report.html").string();
  return result;
}

void declare(CLI::App& app, Options& options) {
  app.add_option("--preset", options.preset, "quick (minutes), standard (an hour or two) or paper")
      ->capture_default_str()
      ->check(CLI::IsMember({"quick", "standard", "paper"}));
}

} // namespace

Command workflow_lj_to_sdpd_command() {
  return {.name = "workflow lj-to-sdpd",
          .summary = "Lennard-Jones MD, equation of state and SDPD in one chain, with a report",
          .example = "mesobridge workflow lj-to-sdpd --preset quick -o out/lj-to-sdpd",
          .declare = with_options(declare, lj_to_sdpd)};
}

} // namespace mesobridge::workflows
