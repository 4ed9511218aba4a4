#include "md/error.hpp"
#include "md/lammps_name.hpp"
#include "scratch_directory.hpp"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace mesobridge::md::test {
namespace {

std::string content(std::filesystem::path const& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(LammpsName, LeadsToTheFileInLettersThatLammpsLeavesAlone) {
  tests::ScratchDirectory const scratch;
  int cases = 0;
  for (std::string const name :
       {"ü", "per%s", "star*", "a \"quoted\" one", "$HOME", "new\nline", "水", "#1 &"}) {
    auto const folder = scratch.path() / name;
    std::filesystem::create_directories(folder);
    {
      LammpsName const written(folder / "lammps.log"); // is not there yet
      std::ofstream(written.text()) << name;
      EXPECT_TRUE(std::ranges::all_of(written.text(), [](char c) { return c > ' ' && c < 127; }));
      EXPECT_EQ(written.text().find_first_of("%*\"$&#"), std::string::npos) << written.text();
    }
    EXPECT_EQ(content(folder / "lammps.log"), name);
    std::filesystem::rename(folder / "lammps.log", folder / name);
    LammpsName const read(folder / name); // its own name is of that kind too
    EXPECT_EQ(content(read.text()), name);
    EXPECT_THROW(LammpsName(folder / (name + "-missing")), InputError);
    ++cases;
  }
  EXPECT_EQ(cases, 8);
}

TEST(LammpsName, LeavesPlainPathsAsTheyAre) {
  EXPECT_EQ(LammpsName("out/lj-1/lammps.log").text(), "out/lj-1/lammps.log");
  EXPECT_EQ(LammpsName("my runs/lammps.log").text(), "my runs/lammps.log");
  EXPECT_THROW(LammpsName("out/"), InputError);
  EXPECT_THROW(LammpsName("fehlt für immer/lammps.log"), EnvironmentError);
}

} // namespace
} // namespace mesobridge::md::test
