#include "include_rule.hpp"
#include <gtest/gtest.h>

namespace mesobridge::tests {

namespace {

TEST(IncludeRule, NoStageIncludesAStageDownstreamOfIt) {
  int files = 0;
  for (auto const& stage : stages)
    for_each_source(stage, [&](std::filesystem::path const& file, std::string const& text) {
      ++files;
      for (auto const& offence : offences(stage, text))
        ADD_FAILURE() << file << ": a file of stage " << stage << " includes " << offence;
    });
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

/// The rooms of the engine, each after those that it may include; files of no room are the simulation's.
std::vector<std::string> const rooms{"simd",       "threads",  "state",      "start",        "kernel",
                                     "potential",  "friction", "conduction", "kinetics",     "thermodynamics",
                                     "neighbours", "system",   "boundary",   "conservative", "fluctuation",
                                     "reaction",   "scheme",   "method",     "observe",      "",
                                     "setup",      "lammps"};

std::string room_of(std::filesystem::path const& file) {
  return file.parent_path().filename() == "sdpd" ? "" : file.parent_path().filename().string();
}

/// The rooms behind `room` that a text includes files of.
std::vector<std::string> rooms_behind(std::string const& room, std::string const& text) {
  static std::regex const include(R"re(#include "(sdpd/[^"]+)")re");
  auto const rank = [](std::string const& name) { return std::ranges::find(rooms, name); };
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match)
    if (auto const other = room_of((*match)[1].str()); rank(other) > rank(room))
      found.push_back((*match)[1]);
  return found;
}

TEST(IncludeRule, NoRoomOfTheEngineIncludesOneBehindIt) {
  int files = 0;
  for_each_source("sdpd", [&](std::filesystem::path const& file, std::string const& text) {
    auto const room = room_of(std::filesystem::relative(file, source));
    ASSERT_NE(std::ranges::find(rooms, room), rooms.end()) << file << " is in a room of no rank";
    for (auto const& offence : rooms_behind(room, text))
      ADD_FAILURE() << file << " includes " << offence;
    ++files;
  });
  EXPECT_GT(files, 80);
  EXPECT_EQ(rooms_behind("kernel", "#include \"sdpd/system/system.hpp\"\n"),
            std::vector<std::string>{"sdpd/system/system.hpp"});
  EXPECT_TRUE(rooms_behind("system", "#include \"sdpd/kernel/list.hpp\"\n").empty());
}

} // namespace

} // namespace mesobridge::tests
