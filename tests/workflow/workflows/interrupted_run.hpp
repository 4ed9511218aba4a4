#pragma once
#include "program.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::tests {

/// The program, interrupted as by Ctrl-C after 3 s, says so in those words and leaves a file of runs, whose
/// states have more than ten rows of that dataset in all.
inline void expect_interrupted(std::vector<std::string> words, std::string const& message,
                               std::filesystem::path const& file, std::string const& dataset) {
  words.insert(words.begin(),
               {"timeout", "--preserve-status", "-s", "INT", "-k", "30", "3", MESOBRIDGE_PROGRAM});
  auto const result = workflows::run_process(words);
  EXPECT_EQ(result.status, 130) << result.errors;
  EXPECT_NE(result.errors.find(message), std::string::npos) << result.errors;
  workflows::Store const store(file, workflows::Store::Mode::read);
  std::size_t samples = 0;
  for (auto const& state : store.list("states"))
    if (auto const name = "states/" + state + "/" + dataset; store.contains(name))
      samples += store.read_doubles(name).size();
  EXPECT_GT(samples, 10u);
}

} // namespace mesobridge::tests
