#include "include_rule.hpp"
#include <gtest/gtest.h>

namespace mesobridge::tests {

namespace {

std::filesystem::path const source{MESOBRIDGE_SOURCE_DIR};

TEST(IncludeRule, NoStageIncludesAStageDownstreamOfIt) {
  int files = 0;
  for (auto const& stage : stages)
    for (auto const& entry : std::filesystem::recursive_directory_iterator(source / stage)) {
      auto const extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp")
        continue;
      ++files;
      for (auto const& offence : offences(stage, read(entry.path())))
        ADD_FAILURE() << entry.path() << ": a file of stage " << stage << " includes " << offence;
    }
  EXPECT_GT(files, 40); // the walk has seen the tree
}

TEST(IncludeRule, AnIncludeDownstreamIsFound) {
  EXPECT_EQ(offences("cg", "#include \"sdpd/cells.hpp\"\n"), std::vector<std::string>{"sdpd/cells.hpp"});
  EXPECT_EQ(offences("md", "#include <vector>\n  # include <cg/estimate.hpp>\n"),
            std::vector<std::string>{"cg/estimate.hpp"});
  EXPECT_EQ(offences("sdpd", "#include \"../workflows/store.hpp\"\n"),
            std::vector<std::string>{"../workflows/store.hpp"});
  EXPECT_EQ(offences("fitting", "#include \"tests/unit/x.hpp\"\n"),
            std::vector<std::string>{"tests/unit/x.hpp"});
}

TEST(IncludeRule, UpstreamAndForeignIncludesAreAllowed) {
  EXPECT_TRUE(
      offences("sdpd", "#include \"md/box.hpp\"\n#include \"sdpd/cells.hpp\"\n#include <vector>\n").empty());
  EXPECT_TRUE(offences("md", "#include <lammps/library.h>\n// #include \"cg/estimate.hpp\"\n").empty());
}

} // namespace

} // namespace mesobridge::tests
