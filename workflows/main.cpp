#include "workflows/command/list.hpp"
#include "workflows/command_line.hpp"
#include "workflows/interrupt.hpp"

int main(int argc, char** argv) {
  mesobridge::workflows::survive_failing_streams();
  return mesobridge::workflows::run_command_line({argv + 1, argv + argc}, mesobridge::workflows::commands());
}
