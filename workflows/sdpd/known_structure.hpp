#pragma once
#include <optional>
#include <string>

namespace mesobridge::workflows {

/// What particles of SDPD are known to become with this kernel, number of neighbours and size, and what to
/// take instead, where that is pairs or a crystal: by what `reproduce structure` has found for argon. Nothing
/// for a fluid or a glass.
std::optional<std::string> known_structure(std::string const& kernel, double neighbours, double K);

} // namespace mesobridge::workflows
