#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "short_run.hpp"
#include <cerrno>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

// A run is broken off in the middle; then one of its files is damaged, and it is resumed. It ends with the
// bits of an unbroken one (the damage was in what is made again, or the checkpoint before the last one did)
// or is refused by a message that names a file: no signal, no hang, no other numbers.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;
using tests::ShortRun;
namespace fs = std::filesystem;

using Random = std::mt19937;

std::size_t below(std::size_t end, Random& random) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

/// Damages a file in one of the ways that disks, copies and editors have; says how.
std::string damage(fs::path const& file, Random& random) {
  auto text = read_text_file(file);
  auto const size = text.size(), place = below(size, random);
  std::string how;
  switch (below(6, random)) {
  case 0:
    text[place] = static_cast<char>(text[place] ^ (1 << below(8, random))), how = "bit";
    break;
  case 1:
    for (std::size_t k = 0; k < 1 + size / 500; ++k)
      text[below(size, random)] = static_cast<char>(below(256, random));
    how = "bytes";
    break;
  case 2:
    text.resize(place), how = "cut";
    break;
  case 3: {
    auto const page = place / 4096 * 4096;
    text.replace(page, std::min<std::size_t>(4096, size - page), std::min<std::size_t>(4096, size - page),
                 '\0');
    how = "zeroed";
    break;
  }
  case 4:
    text.append(1 + below(9000, random), '\7'), how = "longer";
    break;
  default:
    for (std::size_t k = place; k < std::min(size, place + 8); ++k)
      text[k] = '\xff';
    how = "number";
  }
  write_text_file(file, text);
  return fmt::format("{} at {} of {}", how, place, size);
}

struct Outcome {
  int equal = 0, refused = 0;
  std::string wrong;
};

class DamagedFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run(scratch / "whole", false,
                  {"LD_PRELOAD=" MESOBRIDGE_FAULTS, "MESOBRIDGE_FAIL_COUNT=" + (scratch / "count").string()})
                  .status,
              0);
    expected = ShortRun::content(scratch / "whole");
    auto const calls = std::stol(read_text_file(scratch / "count"));
    ASSERT_EQ(run(scratch / "broken", false,
                  {"LD_PRELOAD=" MESOBRIDGE_FAULTS, fmt::format("MESOBRIDGE_FAIL_AT={}", 9 * calls / 10),
                   "MESOBRIDGE_FAIL_MODE=always"})
                  .status,
              4);
    ASSERT_TRUE(fs::exists(scratch / "broken/checkpoint.previous.h5"));
  }

  void try_one(fs::path const& from, std::string const& name, Random& random, Outcome& outcome) {
    auto const folder = scratch / "damaged";
    fs::remove_all(folder);
    fs::copy(from, folder, fs::copy_options::recursive);
    auto const how = damage(folder / name, random);
    auto const ended = run(folder, true);
    bool const names = ended.errors.find(folder.string()) != std::string::npos;
    bool same = false;
    try {
      same = ended.status == 0 && ShortRun::content(folder) == expected;
    } catch (std::exception const&) {
    }
    outcome.equal += same;
    bool const refused = (ended.status == 2 || ended.status == 4) && names &&
                         ended.errors.find("unexpected failure") == std::string::npos;
    outcome.refused += refused;
    if (!same && !refused)
      outcome.wrong += fmt::format("{}, {}: exit {}: {}\n", name, how, ended.status, ended.errors);
  }

  /// Damages each file this often.
  void damage_all(int times, std::vector<std::string> const& names, fs::path const& from) {
    Random random(7);
    for (auto const& name : names) {
      Outcome outcome;
      for (int k = 0; k < times; ++k)
        try_one(from, name, random, outcome);
      std::cout << fmt::format("{:<24} {:>3} damaged: {:>3} equal, {:>3} refused\n", name, times,
                               outcome.equal, outcome.refused);
      EXPECT_EQ(outcome.wrong, "");
      EXPECT_EQ(outcome.equal + outcome.refused, times) << name;
      total += times;
    }
  }

  ScratchDirectory scratch;
  ShortRun run{scratch / "tools"};
  std::map<std::string, std::string> expected;
  int total = 0;

  std::vector<std::string> const of_broken{
      "checkpoint.h5",      "checkpoint.previous.h5", "run.h5",
      "run.h5.undo",        "trajectory.h5md",        "trajectory.h5md.undo",
      "trajectory.vtkhdf",  "trajectory.vtkhdf.undo", "trajectory.xyz",
      "trajectory.xyz.undo"},
      of_whole{"checkpoint.h5",     "run.h5",         "trajectory.h5md",
               "trajectory.vtkhdf", "trajectory.xyz", "trajectory.xyz.seal"};
};

TEST_F(DamagedFiles, AreRefusedOrMended) {
  damage_all(3, of_broken, scratch / "broken");
  damage_all(2, of_whole, scratch / "whole");
  EXPECT_EQ(total, 42);
}

using Long_DamagedFiles = DamagedFiles;

TEST_F(Long_DamagedFiles, AreRefusedOrMended) {
  damage_all(50, of_broken, scratch / "broken");
  damage_all(30, of_whole, scratch / "whole");
  EXPECT_EQ(total, 680);
}

} // namespace
} // namespace mesobridge::workflows
