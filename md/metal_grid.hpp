#pragma once
#include "md/metal.hpp"
#include <span>

namespace mesobridge::md {

/// Who watches several runs, on rank 0; each may be absent. false stops all runs at once.
struct MetalGridConsumers {
  std::function<bool(std::size_t state_index, std::span<MetalSample const>)> samples;
  std::function<bool(std::size_t state_index, MetalEnd const&)> end;
  std::function<bool(double fraction)> progress;
};

/// Samples every state once, as sample_lj_grid does. The seed of a state depends on settings.seed and the
/// state only, so that its samples are the same bit for bit on any number of ranks and in whichever company.
bool sample_metal_grid(MpiWorld const& world, std::span<MetalState const> states,
                       MetalSettings const& settings, MetalGridConsumers const& consumers);

} // namespace mesobridge::md
