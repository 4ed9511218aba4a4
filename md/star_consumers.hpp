#pragma once
#include "md/molecule_atoms.hpp"
#include <functional>

namespace mesobridge::md {

/// Who watches a run of stars; each may be absent.
struct StarConsumers {
  /// Called on every rank with its molecules, at each sample. May be collective.
  std::function<void(MoleculeFrame const&)> frames;
  /// Called on every rank when a stretch of the run has ended, before its checkpoint counts: what was sampled
  /// so far is to be put in safety.
  std::function<void()> checkpoint;
  /// Called on rank 0, often, with the steps done and all steps; false stops the run at once.
  std::function<bool(std::int64_t done, std::int64_t all)> steps;
};

} // namespace mesobridge::md
