#include "cg/single_statistics.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace mesobridge::cg {
namespace {

constexpr std::size_t density_histogram_bins = 40;
/// A bin of the map is computed from this many samples on.
constexpr double fewest_in_map_bin = 50;

/// The sums of Block::moments.
enum Moment : std::size_t { n, P2, P4, K, K2, U, U2, KU, moments };

double mean_of(std::span<double const> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double deviation_of(std::span<double const> values, double mean) {
  double sum = 0;
  for (double x : values)
    sum += (x - mean) * (x - mean);
  return std::sqrt(sum / double(values.size()));
}

/// Independent K and U at a fixed total energy: the covariance of two parts is minus the product of their
/// heat capacities over that of all.
double expected_C_KU(BlobSeries const& series, Correlations const& found) {
  double const c_K = 1.5, c_U = found.beta.mean * found.beta.mean * found.U_variance.mean;
  return -std::sqrt(c_K * c_U) / ((c_K + c_U) * double(series.molecules));
}

} // namespace

std::size_t SingleStatistics::Bins::of(double value) const {
  if (!(value >= low && value < high))
    return count;
  return std::min(count - 1, std::size_t((value - low) / width()));
}

SingleStatistics::SingleStatistics(BlobSeries const& series, CorrelationSettings const& settings)
    : series_(series), U_shift_(mean_of(series.U)), U_spread_(deviation_of(series.U, U_shift_)) {
  double P2 = 0;
  for (auto const& p : series.P)
    P2 += norm2(p) / 3;
  double const spread = std::sqrt(P2 / double(series.P.size()));
  double const K_mean = 1.5 * spread * spread / series.mass;
  P_bins_ = {-4 * spread, 4 * spread, density_histogram_bins};
  U_bins_ = {U_shift_ - 4 * U_spread_, U_shift_ + 5 * U_spread_, density_histogram_bins};
  map_K_ = {0, 3 * K_mean, settings.map_bins};
  map_U_ = {U_shift_ - 3 * U_spread_, U_shift_ + 3 * U_spread_, settings.map_bins};
}

SingleStatistics::Block SingleStatistics::block(std::pair<std::size_t, std::size_t> frames) const {
  Block result;
  result.moments.assign(Moment::moments, 0.0);
  result.P_x.assign(P_bins_.count + 1, 0.0);
  result.P_U.assign(U_bins_.count + 1, 0.0);
  result.map.assign(map_K_.count * map_U_.count + 1, 0.0);
  for (std::size_t k = frames.first * series_.molecules; k < frames.second * series_.molecules; ++k)
    add(k, result);
  return result;
}

void SingleStatistics::add(std::size_t k, Block& block) const {
  Vec3 const& p = series_.P[k];
  double const energy = series_.K(k), intrinsic = series_.U[k] - U_shift_;
  auto& s = block.moments;
  s[Moment::n] += 1;
  s[P2] += norm2(p);
  s[P4] += p.x * p.x * p.x * p.x + p.y * p.y * p.y * p.y + p.z * p.z * p.z * p.z;
  s[K] += energy, s[K2] += energy * energy;
  s[U] += intrinsic, s[U2] += intrinsic * intrinsic, s[KU] += energy * intrinsic;
  for (double const component : {p.x, p.y, p.z}) {
    if (auto const bin = P_bins_.of(component); bin < P_bins_.count)
      block.P_x[bin] += 1;
    block.P_x.back() += 1;
  }
  if (auto const bin = U_bins_.of(series_.U[k]); bin < U_bins_.count)
    block.P_U[bin] += 1;
  block.P_U.back() += 1;
  auto const in_K = map_K_.of(energy), in_U = map_U_.of(series_.U[k]);
  if (in_K < map_K_.count && in_U < map_U_.count)
    block.map[in_K * map_U_.count + in_U] += 1;
  block.map.back() += 1;
}

std::vector<Sums> SingleStatistics::column(std::vector<Block> const& blocks, Sums Block::*member) {
  std::vector<Sums> result;
  for (auto const& block : blocks)
    result.push_back(block.*member);
  return result;
}

void SingleStatistics::moments_into(std::vector<Block> const& blocks, Correlations& out) const {
  auto const estimates = jackknife(column(blocks, &Block::moments), [&](Sums const& s) {
    double const n = s[Moment::n], mean_U = s[U] / n, mean_K = s[K] / n, P2x = s[P2] / (3 * n);
    double const var_U = s[U2] / n - mean_U * mean_U, var_K = s[K2] / n - mean_K * mean_K;
    double const covariance = s[KU] / n - mean_K * mean_U;
    // The total momentum is zero: each molecule has 1 - 1/N of its canonical momentum variance.
    double const free = 1 - 1 / double(series_.molecules);
    return std::vector<double>{series_.mass * free / P2x,
                               s[P4] / (3 * n) / (3 * P2x * P2x) - 1,
                               mean_U + U_shift_,
                               var_U,
                               mean_K,
                               covariance / std::sqrt(var_U * var_K)};
  });
  out.beta = estimates[0], out.kurtosis = estimates[1], out.U_mean = estimates[2];
  out.U_variance = estimates[3], out.K_mean = estimates[4], out.C_KU = estimates[5];
}

Profile SingleStatistics::density(std::vector<Sums> const& sums, Bins const& bins) {
  Profile profile;
  for (std::size_t bin = 0; bin < bins.count; ++bin)
    profile.x.push_back(bins.centre(bin));
  profile.y = jackknife(sums, [&](Sums const& s) {
    std::vector<double> result(s.begin(), s.end() - 1);
    for (double& value : result)
      value /= s.back() * bins.width();
    return result;
  });
  return profile;
}

RelativeErrorMap SingleStatistics::map(std::vector<Block> const& blocks) const {
  RelativeErrorMap map;
  for (std::size_t k = 0; k < map_K_.count; ++k)
    map.K.push_back(map_K_.centre(k));
  for (std::size_t u = 0; u < map_U_.count; ++u)
    map.U.push_back(map_U_.centre(u));
  auto const sums = column(blocks, &Block::map);
  map.error = jackknife(sums, [&](Sums const& s) { return relative_errors(s); });
  Sums whole(sums[0].size(), 0.0);
  for (auto const& s : sums)
    std::transform(whole.begin(), whole.end(), s.begin(), whole.begin(), std::plus{});
  double weight = 0, squares = 0, noise = 0;
  for (std::size_t bin = 0; bin < map.error.size(); ++bin) {
    map.computed.push_back(whole[bin] >= fewest_in_map_bin);
    if (!map.computed.back())
      continue;
    weight += whole[bin];
    squares += whole[bin] * map.error[bin].mean * map.error[bin].mean;
    noise += whole[bin] * map.error[bin].se * map.error[bin].se;
  }
  map.typical = weight > 0 ? std::sqrt(squares / weight) : 0;
  map.typical_from_noise = weight > 0 ? std::sqrt(noise / weight) : 0;
  return map;
}

/// 1 - P(K)P(U)/P(K,U) within the grid; 0 where nothing was seen.
std::vector<double> SingleStatistics::relative_errors(Sums const& s) const {
  std::size_t const rows = map_K_.count, columns = map_U_.count;
  std::vector<double> of_K(rows, 0.0), of_U(columns, 0.0), result(rows * columns, 0.0);
  double all = 0;
  for (std::size_t k = 0; k < rows; ++k)
    for (std::size_t u = 0; u < columns; ++u) {
      of_K[k] += s[k * columns + u];
      of_U[u] += s[k * columns + u];
      all += s[k * columns + u];
    }
  for (std::size_t k = 0; k < rows; ++k)
    for (std::size_t u = 0; u < columns; ++u)
      if (double const joint = s[k * columns + u]; joint > 0)
        result[k * columns + u] = 1 - of_K[k] * of_U[u] / (joint * all);
  return result;
}

void SingleStatistics::results_into(std::vector<std::pair<std::size_t, std::size_t>> const& blocks,
                                    Correlations& out) const {
  std::vector<Block> sums;
  for (auto const& frames : blocks)
    sums.push_back(block(frames));
  moments_into(sums, out);
  out.P_x = density(column(sums, &Block::P_x), P_bins_);
  out.P_U = density(column(sums, &Block::P_U), U_bins_);
  out.map = map(sums);
  out.C_KU_expected = expected_C_KU(series_, out);
}

} // namespace mesobridge::cg
