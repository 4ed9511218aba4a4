#include "scratch_directory.hpp"
#include "workflows/eos_fit/column_guide.hpp"
#include "workflows/eos_fit/data_file.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <sstream>

namespace mesobridge::workflows {
namespace {

/// The examples of the guide are its lines of four blanks, two by two.
TEST(ColumnGuide, HasExamplesThatAreReadAsItSays) {
  tests::ScratchDirectory const scratch;
  std::istringstream text(column_guide());
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("    "))
      lines.push_back(line.substr(4));
  ASSERT_EQ(lines.size(), 8u);
  std::vector<fitting::DataPath> const paths{fitting::DataPath::state, fitting::DataPath::hugoniot,
                                             fitting::DataPath::isentrope, fitting::DataPath::cj};
  for (std::size_t k = 0; k < paths.size(); ++k) {
    write_text_file(scratch / "example.csv", lines[2 * k] + "\n" + lines[2 * k + 1] + "\n");
    auto const data = read_eos_data(scratch / "example.csv", {});
    ASSERT_EQ(data.observations.size(), 1u) << lines[2 * k];
    EXPECT_EQ(data.observations[0].path, paths[k]) << lines[2 * k];
    EXPECT_FALSE(data.observations[0].measured.empty()) << lines[2 * k];
  }
}

} // namespace
} // namespace mesobridge::workflows
