#include "fuzz/kinds/driven_scene.hpp"
#include "hdf5_numbers.hpp"
#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <iostream>
#include <map>

// Random scenes with pistons, walls and open faces (tests/fuzz/kinds/driven_scene.hpp makes them; the fuzzer
// makes thousands): each ends well with finite numbers everywhere, or says by its exit code what is wrong.

namespace mesobridge::workflows {
namespace {

std::string fault_of_scene(std::filesystem::path const& folder, std::uint64_t seed,
                           std::map<int, int>& ends) {
  fuzz::Random random(seed);
  write_text_file(folder / "scene.toml", fuzz::DrivenScene(random).text());
  auto const out = folder / "out";
  std::filesystem::remove_all(out);
  auto const result =
      run_process({"timeout", "-k", "5", "60", MESOBRIDGE_PROGRAM, "run", folder / "scene.toml", "-o", out,
                   "--quiet", "--no-report", "--threads", "1"});
  ++ends[result.status];
  if (auto const fault = fuzz::fault_of_driven(result.status, result.output + result.errors); !fault.empty())
    return fault + ": " + result.errors;
  if (!std::filesystem::exists(out))
    return "";
  if (std::filesystem::exists(out / "summary.json")) // as JSON writes what is no number
    if (read_text_file(out / "summary.json").find("nan") != std::string::npos)
      return "summary.json holds a nan";
  return tests::not_finite_in(out);
}

TEST(DrivenScenes, EndWellOrSayWhyTheyDoNot) {
  tests::ScratchDirectory const scratch;
  std::map<int, int> ends;
  int made = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed, ++made)
    EXPECT_EQ(fault_of_scene(scratch.path(), seed, ends), "") << seed << "\n"
                                                              << read_text_file(scratch / "scene.toml");
  for (auto const& [status, count] : ends)
    std::cout << fmt::format("{} ended with {}\n", count, status);
  EXPECT_EQ(made, 50);
  EXPECT_GE(ends[0], 25); // most of them run
}

} // namespace
} // namespace mesobridge::workflows
