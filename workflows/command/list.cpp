#include "workflows/command/list.hpp"

namespace mesobridge::workflows {

std::vector<Command> commands() {
  return {
      run_command(),
      check_command(),
      bench_engine_command(),
      doctor_command(),
  };
}

} // namespace mesobridge::workflows
