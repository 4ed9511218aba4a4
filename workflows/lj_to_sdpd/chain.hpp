#pragma once
#include "workflows/command.hpp"
#include "workflows/lj_to_sdpd/plan.hpp"
#include "workflows/lj_to_sdpd/results.hpp"
#include "workflows/provenance.hpp"

namespace mesobridge::workflows {

/// Runs the whole chain into a directory: md/ (samples), state-grid.h5, lj-bwr.toml (the fitted argon), sdpd/
/// (one folder a run). Throws as its stages do; Interrupted leaves what was written.
ChainResults run_chain(md::Preset preset, std::string const& preset_name,
                       std::filesystem::path const& directory, Context const& context);

/// All numbers of the chain for summary.json.
Json chain_summary(ChainResults const& results);

/// The report of the chain as HTML.
std::string chain_report(ChainResults const& results, Provenance const& provenance);

} // namespace mesobridge::workflows
