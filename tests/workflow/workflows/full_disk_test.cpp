#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "short_run.hpp"
#include <cerrno>
#include <fmt/format.h>
#include <gtest/gtest.h>

// A run on a disk that is full, or fails, from any moment on; then there is room again, and it is resumed. It
// ends with the bits of a run that had no such trouble, or says which file cannot be gone on with.
// tests/fault/fault_injection.cpp lets the calls fail: each n-th of a run in turn, or each k-th of them.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;
using tests::ShortRun;
namespace fs = std::filesystem;

struct Fault {
  char const* mode;
  int error;
};

/// How the trials of one kind of fault ended.
struct Tally {
  int trials = 0;
  int unharmed = 0;         ///< the run itself ended well, and with the right bits
  int equal = 0;            ///< the resumed one did
  int refused_at_start = 0; ///< nothing had been written that could be resumed
  int refused = 0;          ///< with a message that names a file of the run
  std::string wrong;        ///< all others
};

std::vector<std::string> environment(Fault const& fault, long at) {
  return {"LD_PRELOAD=" MESOBRIDGE_FAULTS, fmt::format("MESOBRIDGE_FAIL_AT={}", at),
          fmt::format("MESOBRIDGE_FAIL_MODE={}", fault.mode),
          fmt::format("MESOBRIDGE_FAIL_ERRNO={}", fault.error)};
}

bool equal(fs::path const& folder, std::map<std::string, std::string> const& expected) {
  try {
    return ShortRun::content(folder) == expected;
  } catch (std::exception const&) {
    return false;
  }
}

void try_fault(ShortRun const& run, fs::path const& folder,
               std::map<std::string, std::string> const& expected, Fault const& fault, long at,
               Tally& tally) {
  fs::remove_all(folder);
  ++tally.trials;
  auto const first = run(folder, false, environment(fault, at));
  auto const wrong = [&](ProcessResult const& ended) {
    tally.wrong += fmt::format("{} {} at {}: exit {}, then {}: {}{}\n", fault.mode, fault.error, at,
                               first.status, ended.status, first.errors, ended.errors);
  };
  if (first.status == 0)
    return equal(folder, expected) ? void(++tally.unharmed) : wrong(first);
  if (first.status != 4 || first.errors.find(folder.string()) == std::string::npos)
    return wrong(first);
  bool const begun = fs::exists(folder / "scene.toml");
  auto const second = run(folder, true);
  if (second.status == 0)
    return equal(folder, expected) ? void(++tally.equal) : wrong(second);
  bool const named =
      (second.status == 2 || second.status == 4) && second.errors.find(folder.string()) != std::string::npos;
  if (!named)
    return wrong(second);
  ++(begun ? tally.refused : tally.refused_at_start);
}

class FullDisk : public ::testing::Test {
 protected:
  /// Tries each `step`-th call, from `start` on.
  Tally sweep(Fault const& fault, long start, long step) {
    Tally tally;
    for (long at = start; at <= calls; at += step)
      try_fault(run, scratch / "faulty", expected, fault, at, tally);
    std::cout << fmt::format(
        "{:<6} errno {:>3}: {} trials, {} unharmed, {} equal after --resume, {} refused by "
        "name, {} had nothing to resume\n",
        fault.mode, fault.error, tally.trials, tally.unharmed, tally.equal, tally.refused,
        tally.refused_at_start);
    EXPECT_EQ(tally.wrong, "");
    EXPECT_EQ(tally.refused, 0);
    EXPECT_EQ(tally.unharmed + tally.equal + tally.refused + tally.refused_at_start, tally.trials);
    return tally;
  }

  void SetUp() override {
    auto const ended =
        run(scratch / "whole", false,
            {"LD_PRELOAD=" MESOBRIDGE_FAULTS, "MESOBRIDGE_FAIL_COUNT=" + (scratch / "count").string()});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    calls = std::stol(read_text_file(scratch / "count"));
    ASSERT_GT(calls, 300);
    expected = ShortRun::content(scratch / "whole");
    ASSERT_GT(expected.size(), 40u);
    // The answer is that of a run without the library, too.
    ASSERT_EQ(run(scratch / "plain", false).status, 0);
    ASSERT_TRUE(equal(scratch / "plain", expected));
  }

  ScratchDirectory scratch;
  ShortRun run{scratch / "tools"};
  std::map<std::string, std::string> expected;
  long calls = 0;
};

constexpr Fault full{"full", ENOSPC}, always{"always", ENOSPC}, broken{"once", EIO}, quota{"short", EDQUOT},
    half{"half", ENOSPC}, limit{"full", EFBIG};

TEST_F(FullDisk, AtSomeMomentsLosesNothing) {
  constexpr long trials = 10; // of each fault
  for (Fault const& fault : {full, always, broken, quota})
    EXPECT_GE(sweep(fault, 1 + calls / trials / 3, calls / trials).equal, 4);
  EXPECT_GE(sweep(half, 20, calls / 4).unharmed, 3);
}

class FullDiskSweep : public FullDisk, public ::testing::WithParamInterface<Fault> {};

TEST_P(FullDiskSweep, AtAnyMomentLosesNothing) {
  EXPECT_EQ(sweep(GetParam(), 1, 1).trials, calls);
}

INSTANTIATE_TEST_SUITE_P(Long_Faults, FullDiskSweep,
                         ::testing::Values(full, always, broken, quota, half, limit), [](auto const& info) {
                           return fmt::format("{}_{}", info.param.mode, info.param.error);
                         });

// What the tests above would see.
TEST_F(FullDisk, ChangesTheRunsBits) {
  auto other = expected;
  other.at("run.h5:thermodynamics")[100] ^= 1;
  EXPECT_FALSE(equal(scratch / "whole", other));
  EXPECT_EQ(run(scratch / "faulty", false, environment(full, calls / 2)).status, 4);
  EXPECT_FALSE(equal(scratch / "faulty", expected));
}

} // namespace
} // namespace mesobridge::workflows
