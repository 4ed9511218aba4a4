#pragma once
#include <gtest/gtest.h>
#include <string>

namespace mesobridge::tests {

/// The text with its first `what` turned into `by`; a failure of the test when there is none.
inline std::string replaced(std::string text, std::string const& what, std::string const& by) {
  auto const at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

} // namespace mesobridge::tests
