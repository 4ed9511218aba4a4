#pragma once
#include <filesystem>
#include <string>

namespace mesobridge::workflows {

/// Processors that this process may use, >= 1: those of its affinity, and no more than the quota of its
/// control group allows (containers, batch systems).
int available_processors();

/// The quota of a control group in processors, infinite if it has none: the smallest of the group's own and
/// of those above it. `groups` is what /proc/self/cgroup says, `root` where the groups are mounted.
/// Understands both versions of control groups; what cannot be read is no limit.
double processor_quota(std::string const& groups, std::filesystem::path const& root);

} // namespace mesobridge::workflows
