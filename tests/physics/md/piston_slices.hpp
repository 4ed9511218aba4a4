#pragma once
#include "md/piston_drive.hpp"
#include <filesystem>
#include <gtest/gtest.h>

namespace mesobridge::md::test {

/// All slices that a run of so many steps tells; its log is removed.
template <class Settings>
std::vector<PistonSlices> slices_of(bool (*sample)(MpiWorld const&, Settings const&, std::int64_t,
                                                   PistonConsumers const&),
                                    Settings const& settings, std::int64_t steps) {
  std::vector<PistonSlices> all;
  PistonConsumers const consumers{.slices = [&](auto const& slices) { return all.push_back(slices), true; },
                                  .steps = {}};
  EXPECT_TRUE(sample(MpiWorld(), settings, steps, consumers));
  std::filesystem::remove(settings.log_file);
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
