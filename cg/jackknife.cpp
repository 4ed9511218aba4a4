#include "cg/jackknife.hpp"
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::cg {

std::vector<Estimate> jackknife(std::span<Sums const> blocks,
                                std::function<std::vector<double>(Sums const&)> const& statistics) {
  require(blocks.size() >= 4, "jackknife blocks", blocks.size(), "at least 4 are needed");
  Sums whole(blocks[0].size(), 0.0);
  for (auto const& block : blocks)
    for (std::size_t k = 0; k < whole.size(); ++k)
      whole[k] += block[k];
  auto const of_whole = statistics(whole);
  std::size_t const count = of_whole.size();
  std::vector<double> sum(count, 0.0), squares(count, 0.0);
  Sums kept(whole.size());
  for (auto const& block : blocks) {
    for (std::size_t k = 0; k < whole.size(); ++k)
      kept[k] = whole[k] - block[k];
    auto const values = statistics(kept);
    for (std::size_t s = 0; s < count; ++s) {
      double const off = values[s] - of_whole[s]; // free of cancellation in the squares
      sum[s] += off;
      squares[s] += off * off;
    }
  }
  double const m = double(blocks.size());
  std::vector<Estimate> estimates;
  for (std::size_t s = 0; s < count; ++s) {
    double const mean = sum[s] / m;
    double const variance = std::max(0.0, squares[s] - m * mean * mean);
    estimates.push_back({of_whole[s] - (m - 1) * mean, std::sqrt((m - 1) / m * variance), m});
  }
  return estimates;
}

} // namespace mesobridge::cg
