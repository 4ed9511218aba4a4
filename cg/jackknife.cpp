#include "cg/jackknife.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {

Estimate jackknifed(double whole, std::span<double const> without) {
  double const blocks = double(without.size());
  double sum = 0, squares = 0;
  for (double const other : without) {
    double const off = other - whole; // free of cancellation in the squares
    sum += off, squares += off * off;
  }
  double const mean = sum / blocks;
  double const variance = std::max(0.0, squares - blocks * mean * mean);
  return {whole - (blocks - 1) * mean, std::sqrt((blocks - 1) / blocks * variance), blocks};
}

std::vector<Sums> without_each(std::span<Sums const> blocks) {
  Sums whole(blocks[0].size(), 0.0);
  for (auto const& block : blocks)
    std::transform(whole.begin(), whole.end(), block.begin(), whole.begin(), std::plus{});
  std::vector<Sums> result;
  for (auto const& block : blocks) {
    Sums rest = whole;
    std::transform(rest.begin(), rest.end(), block.begin(), rest.begin(), std::minus{});
    result.push_back(std::move(rest));
  }
  result.push_back(std::move(whole));
  return result;
}

std::vector<Estimate> jackknife(std::span<Sums const> blocks,
                                std::function<std::vector<double>(Sums const&)> const& statistics) {
  require(blocks.size() >= 4, "jackknife blocks", blocks.size(), "at least 4 are needed");
  auto const rests = without_each(blocks);
  auto const whole = statistics(rests.back());
  std::vector<std::vector<double>> without(whole.size()); // [statistic][block]
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    auto const values = statistics(rests[block]);
    for (std::size_t s = 0; s < whole.size(); ++s)
      without[s].push_back(values[s]);
  }
  std::vector<Estimate> estimates;
  for (std::size_t s = 0; s < whole.size(); ++s)
    estimates.push_back(jackknifed(whole[s], without[s]));
  return estimates;
}

} // namespace mesobridge::cg
