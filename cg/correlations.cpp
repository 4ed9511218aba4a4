#include "cg/correlations.hpp"
#include "cg/key_tests.hpp"
#include "cg/pair_statistics.hpp"
#include "cg/single_statistics.hpp"
#include "cg/too_short.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace mesobridge::cg {
namespace {

constexpr std::size_t fewest_blocks = 8, most_blocks = 50;
/// A block lasts this many of the longest autocorrelation time: the errors are then at most 9 % low.
constexpr double taus_in_block = 6;

std::vector<double> momentum_components(BlobSeries const& series) {
  std::vector<double> components; // three times as many molecules
  for (auto const& p : series.P)
    components.insert(components.end(), {p.x, p.y, p.z});
  return components;
}

} // namespace

Correlations correlations(BlobSeries const& series, CorrelationSettings const& settings) {
  require(series.molecules >= 2, "molecules", series.molecules, "at least 2 are needed for correlations");
  PairStatistics const pairs(series, settings);
  Correlations result;
  result.tau_U = memory_time(series.U, series.molecules, series.interval());
  result.tau_P = memory_time(momentum_components(series), 3 * series.molecules, series.interval());
  result.tau_rho =
      memory_time(pairs.densities(), series.molecules, series.interval() * double(settings.pair_stride));
  double const longest = std::max({result.tau_U.tau, result.tau_P.tau, result.tau_rho.tau});
  double const all_time = series.interval() * double(series.frames());
  double const possible = all_time / (taus_in_block * longest);
  double const needed = taus_in_block * longest * double(fewest_blocks);
  if (possible < double(fewest_blocks))
    throw TooShort(
        fmt::format("the run of {:.4g} time units is too short for standard errors: its longest "
                    "autocorrelation time is {:.3g} (P {:.3g}, U {:.3g}, local density {:.3g}), so "
                    "at least {:.4g} are needed",
                    all_time, longest, result.tau_P.tau, result.tau_U.tau, result.tau_rho.tau, needed),
        needed);
  result.blocks = std::min(most_blocks, std::size_t(possible));
  result.block_time = all_time / double(result.blocks);

  auto const blocks = time_blocks(series.frames(), result.blocks);
  SingleStatistics(series, settings).results_into(blocks, result);
  pairs.results_into(blocks, result);

  double const P2x = series.mass / result.beta.mean;
  double const factor = P2x / (series.mass * series.mass);
  result.D = {factor * result.tau_P.tau, factor * result.tau_P.se, double(result.blocks)};
  double const volume = series.boxes.front().volume() / double(series.molecules);
  result.tau_R = std::pow(volume, 2.0 / 3) / (6 * result.D.mean);
  for (std::size_t m = 0; m < series.molecules; ++m) { // the first frame
    result.K_snapshot.push_back(series.K(m));
    result.U_snapshot.push_back(series.U[m]);
    result.density_snapshot.push_back(pairs.densities()[m]);
  }
  result.tests = key_tests(result);
  return result;
}

double lucy(double r, double h) {
  double const x = r / h, rest = 1 - x;
  return x < 1 ? 105 / (16 * std::numbers::pi * h * h * h) * (1 + 3 * x) * rest * rest * rest : 0;
}

} // namespace mesobridge::cg
