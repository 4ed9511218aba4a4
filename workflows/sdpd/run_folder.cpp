#include "workflows/sdpd/run_folder.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {

bool RunFolder::stopped_before_first_checkpoint(std::string const& resolved_scene) const {
  return !has_checkpoint() && std::filesystem::exists(scene()) && read_text_file(scene()) == resolved_scene;
}

} // namespace mesobridge::workflows
