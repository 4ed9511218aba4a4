#pragma once
#include "md/piston_drive.hpp"
#include <filesystem>
#include <gtest/gtest.h>

namespace mesobridge::md::test {

/// All slices that `sample`, which is given the consumers, tells; its log is removed.
template <class Sample>
std::vector<PistonSlices> slices_of(std::filesystem::path const& log_file, Sample const& sample) {
  std::vector<PistonSlices> all;
  EXPECT_TRUE(sample(PistonConsumers{
      .slices = [&](auto const& slices) { return all.push_back(slices), true; }, .steps = {}}));
  std::filesystem::remove(log_file);
  return all;
}

/// Mean over the slices from `first` to before `last`, weighted with their atoms.
inline double mean(PistonSlices const& now, std::vector<double> const& values, int first, int last) {
  double sum = 0, n = 0;
  for (auto s = std::size_t(first); s < std::size_t(last); ++s)
    sum += now.number[s] * values[s], n += now.number[s];
  return sum / n;
}

} // namespace mesobridge::md::test
