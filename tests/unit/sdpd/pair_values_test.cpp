#include "sdpd/neighbours/pair_values.hpp"
#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace mesobridge::sdpd {
namespace {

TEST(PairValues, AreThoseOfBothParticlesUpToTheLastPlaceThatABlockCanHave) {
  std::size_t const places = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
  std::vector<double> values;
  for (std::size_t place = 0; place < places; ++place)
    values.push_back(1.0 / (1.0 + static_cast<double>(place)));
  std::array<LocalPair, lane_count> const pairs{
      {{0, 65535}, {65535, 0}, {1, 2}, {32767, 32768}, {32768, 32767}, {7, 7}, {300, 40000}, {65534, 65535}}};
  auto const [i, j] = values_of(values.data(), pairs.data());
  for (std::size_t l = 0; l < lane_count; ++l) {
    EXPECT_EQ(i[l], values[pairs[l].i]) << l;
    EXPECT_EQ(j[l], values[pairs[l].j]) << l;
  }
}

} // namespace
} // namespace mesobridge::sdpd
