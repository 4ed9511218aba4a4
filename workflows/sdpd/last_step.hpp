#pragma once
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// The last number of a series of steps in a file, -1 when there is none.
inline std::int64_t last_step(Store const& store, std::string const& dataset) {
  if (!store.contains(dataset))
    return -1;
  auto const steps = store.read_integers(dataset);
  return steps.empty() ? -1 : steps.back();
}

} // namespace mesobridge::workflows
