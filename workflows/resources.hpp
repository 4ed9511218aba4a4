#pragma once
#include <filesystem>

namespace mesobridge::workflows {

/// Bytes of memory that this process can still take: what the machine has free, its swap with it, or less
/// where a control group or `ulimit -v` says so. Infinite where the system does not tell.
double available_memory();

/// Bytes that can still be written into a folder, which need not exist yet. Infinite where the system does
/// not tell.
double available_disk(std::filesystem::path const& folder);

} // namespace mesobridge::workflows
