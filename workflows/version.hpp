#pragma once
#include <string_view>

namespace mesobridge::workflows {

/// The program's version, "0.1.0".
std::string_view version();

/// The git commit it was built from, with "-dirty" when files had been changed; "unknown" outside a checkout.
std::string_view git_commit();

} // namespace mesobridge::workflows
