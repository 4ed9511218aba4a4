#pragma once
#include "program.hpp"

namespace mesobridge::tests {

/// Words that the program refuses.
struct Refusal {
  std::vector<std::string> words;
  int code;
  std::string message;
};

/// Returns how many were tried.
inline int expect_refusals(std::vector<Refusal> const& cases) {
  int tried = 0;
  for (auto const& [words, code, message] : cases) {
    expect_refusal(program(words), code, message);
    ++tried;
  }
  return tried;
}

} // namespace mesobridge::tests
