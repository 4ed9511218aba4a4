#pragma once
#include "program.hpp"
#include "workflows/command.hpp"
#include <sstream>

namespace mesobridge::tests {

/// Runs `mesobridge eos` with the words of a line.
inline workflows::ProcessResult eos(std::string const& line) {
  std::istringstream stream(line);
  std::vector<std::string> words{"eos"};
  for (std::string word; stream >> word;)
    words.push_back(word);
  return program(words);
}

/// Its result; fails where it does not succeed.
inline workflows::Json json_of(std::string const& line) {
  auto const result = eos(line + " --json");
  EXPECT_EQ(result.status, 0) << line << "\n" << result.errors;
  return result.status == 0 ? workflows::Json::parse(result.output) : workflows::Json::object();
}

/// To a relative tolerance.
inline void expect_near(workflows::Json const& found, std::string const& key, double expected,
                        double tolerance) {
  ASSERT_TRUE(found.contains(key)) << key << " in " << found.dump(2).substr(0, 2000);
  EXPECT_NEAR(found[key].get<double>() / expected, 1, tolerance) << key;
}

} // namespace mesobridge::tests
