#pragma once
#include "md/metal.hpp"
#include "workflows/metal/metal_sampler.hpp"

namespace mesobridge::workflows {

/// The options that every command for metals has.
struct MetalOptions {
  std::string potential, element, lattice, preset = "quick", start = "solid";
  std::optional<int> atoms;
  std::optional<std::int64_t> melt_steps, equilibration_steps, sampling_steps;
  std::optional<double> time_step;
  bool resume = false;
  bool started_by_ourselves = false;
};

void add_options(CLI::App& app, MetalOptions& options);

/// What a run is made with; the log file is left to the caller. Throws InputError.
md::MetalSettings settings_of(MetalOptions const& options, Context const& context);

/// Sets aside what an earlier call left in the folder, unless the job goes on from it: its runs, the results
/// "name.h5", "name.csv" and "name.json", and the log.
void keep_earlier_results(MetalOptions const& options, MetalJob const& job,
                          std::filesystem::path const& directory, std::string const& name,
                          Context const& context);

} // namespace mesobridge::workflows
