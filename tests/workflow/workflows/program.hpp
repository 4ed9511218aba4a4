#pragma once
#include "workflows/process.hpp"

namespace mesobridge::tests {

/// Runs the program itself, as a user would.
inline workflows::ProcessResult program(std::vector<std::string> words) {
  words.insert(words.begin(), MESOBRIDGE_PROGRAM);
  return workflows::run_process(words);
}

} // namespace mesobridge::tests
