#include "workflows/version.hpp"
#include "generated/git_commit.hpp"

namespace mesobridge::workflows {

std::string_view version() {
  return MESOBRIDGE_VERSION;
}

std::string_view git_commit() {
  return generated::git_commit;
}

} // namespace mesobridge::workflows
