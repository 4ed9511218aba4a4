#include "workflows/command/list.hpp"

namespace mesobridge::workflows {

std::vector<Command> commands() {
  return {
      check_command(),
      doctor_command(),
  };
}

} // namespace mesobridge::workflows
