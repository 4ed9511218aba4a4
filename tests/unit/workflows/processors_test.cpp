#include "scratch_directory.hpp"
#include "workflows/processors.hpp"
#include "workflows/text_file.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

namespace mesobridge::workflows {
namespace {

void put(std::filesystem::path const& file, std::string const& text) {
  std::filesystem::create_directories(file.parent_path());
  write_text_file(file, text);
}

TEST(Processors, OfAControlGroupAreThoseOfTheNarrowestAboveIt) {
  tests::ScratchDirectory const scratch;
  put(scratch / "cpu.max", "max 100000\n");
  put(scratch / "batch" / "cpu.max", "150000 100000\n");
  put(scratch / "batch" / "job" / "cpu.max", "400000 100000\n");
  put(scratch / "free" / "cpu.max", "max 100000\n");
  put(scratch / "broken" / "cpu.max", "what is this\n");
  EXPECT_DOUBLE_EQ(processor_quota("0::/batch/job\n", scratch / ""), 1.5);
  EXPECT_DOUBLE_EQ(processor_quota("0::/batch\n", scratch / ""), 1.5);
  for (auto const* groups : {"0::/free\n", "0::/\n", "0::/broken\n", "0::/not/there\n", "", "nonsense\n"})
    EXPECT_TRUE(std::isinf(processor_quota(groups, scratch / ""))) << groups;
}

TEST(Processors, OfTheFirstVersionOfControlGroupsAreReadToo) {
  tests::ScratchDirectory const scratch;
  put(scratch / "cpu,cpuacct" / "docker" / "cpu.cfs_quota_us", "50000\n");
  put(scratch / "cpu,cpuacct" / "docker" / "cpu.cfs_period_us", "100000\n");
  put(scratch / "cpu,cpuacct" / "cpu.cfs_quota_us", "-1\n");
  put(scratch / "cpu,cpuacct" / "cpu.cfs_period_us", "100000\n");
  EXPECT_DOUBLE_EQ(processor_quota("7:memory:/docker\n4:cpu,cpuacct:/docker\n", scratch / ""), 0.5);
  EXPECT_TRUE(std::isinf(processor_quota("4:cpu,cpuacct:/\n", scratch / "")));
  EXPECT_TRUE(std::isinf(processor_quota("3:cpuset:/docker\n", scratch / "")));
}

TEST(Processors, OfThisProcessAreSomeAndNoMoreThanThereAre) {
  EXPECT_GE(available_processors(), 1);
  EXPECT_LE(available_processors(), static_cast<int>(std::thread::hardware_concurrency()));
}

} // namespace
} // namespace mesobridge::workflows
