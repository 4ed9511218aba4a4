#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/lj_to_sdpd/chain.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {
namespace {

struct WorkflowLjToSdpdOptions {
  std::string preset = "quick";
};

Result lj_to_sdpd(WorkflowLjToSdpdOptions const& options, Context const& context) {
  auto const directory = context.output_directory("out/lj-to-sdpd");
  FolderLock const lock(directory, context.command_line());
  auto const results = run_chain(preset_of(options.preset), options.preset, directory, context);
  Provenance const provenance{context.command_line(),
                              context.options.seed.value_or(1),
                              "",
                              {directory / "md" / "lj-grid.h5", directory / "lj-bwr.toml"}};
  return with_report(directory, chain_summary(results), chain_report(results, provenance));
}

void declare(CLI::App& app, WorkflowLjToSdpdOptions& options) {
  add_preset(app, options.preset, "quick (minutes), standard (an hour or two) or paper")
      ->capture_default_str();
}

} // namespace

extern Declaration const workflow_lj_to_sdpd_command =
    with_options<WorkflowLjToSdpdOptions, declare, lj_to_sdpd>;

} // namespace mesobridge::workflows
