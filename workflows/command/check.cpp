#include "workflows/command/list.hpp"

namespace mesobridge::workflows {

Command check_command() {
  return {.name = "check",
          .summary = "Validate a scene and print it as resolved; runs nothing",
          .example = "mesobridge check workflows/scenes/argon-1000K.toml",
          .declare = [](CLI::App&) { return [](Context&) { return Result{}; }; }};
}

} // namespace mesobridge::workflows
