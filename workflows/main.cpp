#include "workflows/command/list.hpp"
#include "workflows/command_line.hpp"

int main(int argc, char** argv) {
  return mesobridge::workflows::run_command_line({argv + 1, argv + argc}, mesobridge::workflows::commands());
}
