#include "include_rule.hpp"
#include <gtest/gtest.h>

namespace mesobridge::tests {

namespace {

std::ptrdiff_t lines_of(std::string const& text) {
  return std::ranges::count(text, '\n');
}

// A file holds one concept and is read from top to bottom.
TEST(FileLength, NoFileOfAStageIsTooLongToBeRead) {
  constexpr std::ptrdiff_t longest = 300;
  int files = 0;
  for (auto const& stage : stages)
    for_each_source(stage, [&](std::filesystem::path const& file, std::string const& text) {
      EXPECT_LE(lines_of(text), longest) << file << ": split it by concept";
      ++files;
    });
  EXPECT_GT(files, 400); // the walk has seen the tree
  EXPECT_EQ(lines_of("one\ntwo\n"), 2);
}

} // namespace

} // namespace mesobridge::tests
