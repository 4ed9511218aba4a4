#pragma once
#include "workflows/process.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace mesobridge::tests {

/// Runs the program itself, as a user would.
inline workflows::ProcessResult program(std::vector<std::string> words) {
  words.insert(words.begin(), MESOBRIDGE_PROGRAM);
  return workflows::run_process(words);
}

/// It ended with that exit code and one line that holds the message.
inline void expect_refusal(workflows::ProcessResult const& result, int code, std::string const& message) {
  EXPECT_EQ(result.status, code) << result.errors;
  EXPECT_NE(result.errors.find(message), std::string::npos) << message << "\n" << result.errors;
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  EXPECT_EQ(result.output, "");
}

} // namespace mesobridge::tests
