#pragma once
#include <functional>
#include <vector>

namespace mesobridge::workflows {

/// Runs independent jobs on that many threads, the first in the list first. When jobs throw, no further ones
/// are begun and the exception of the earliest in the list is thrown once the running ones have ended.
void run_jobs(std::vector<std::function<void()>> const& jobs, int threads);

} // namespace mesobridge::workflows
