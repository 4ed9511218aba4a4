#pragma once
#include "workflows/command.hpp"
#include <vector>

namespace mesobridge::workflows {

/// Every command of the program, in the order in which the help shows them. A new command is its own file in
/// this folder, and its name in list.cpp.
std::vector<Command> commands();

} // namespace mesobridge::workflows
