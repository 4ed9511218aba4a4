#include "include_rule.hpp"
#include <gtest/gtest.h>

namespace mesobridge::tests {

namespace {

std::filesystem::path const source{MESOBRIDGE_SOURCE_DIR};

std::ptrdiff_t lines_of(std::string const& text) {
  return std::ranges::count(text, '\n');
}

// A file holds one concept and is read from top to bottom.
TEST(FileLength, NoFileOfAStageIsTooLongToBeRead) {
  constexpr std::ptrdiff_t longest = 300;
  int files = 0;
  for (auto const& stage : stages)
    for (auto const& entry : std::filesystem::recursive_directory_iterator(source / stage)) {
      auto const extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp")
        continue;
      EXPECT_LE(lines_of(read(entry.path())), longest) << entry.path() << ": split it by concept";
      ++files;
    }
  EXPECT_GT(files, 400); // the walk has seen the tree
  EXPECT_EQ(lines_of("one\ntwo\n"), 2);
}

} // namespace

} // namespace mesobridge::tests
