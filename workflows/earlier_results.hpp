#pragma once
#include <filesystem>
#include <vector>

namespace mesobridge::workflows {

struct Context;

/// Moves those of the files that exist into the first free folder "backup-N" of `folder`, which is returned
/// (empty where none exists). Files of other names stay where they are. Throws EnvironmentError when a move
/// fails.
std::filesystem::path set_aside(std::filesystem::path const& folder,
                                std::vector<std::filesystem::path> const& files);

/// The same for what an earlier call of a sampling command left, told to the user: hours of sampling are not
/// replaced by a word that was forgotten. On the process that the user has started (of several, on the root)
/// only.
void keep_earlier_results(Context const& context, bool started_by_ourselves,
                          std::filesystem::path const& folder,
                          std::vector<std::filesystem::path> const& files);

} // namespace mesobridge::workflows
