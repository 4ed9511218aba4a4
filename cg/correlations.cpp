#include "cg/correlations.hpp"
#include "cg/jackknife.hpp"
#include "cg/pair_statistics.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mesobridge::cg {
namespace {

constexpr std::size_t fewest_blocks = 8, most_blocks = 50;
/// A block lasts this many of the longest autocorrelation time: the errors are then at most 9 % low.
constexpr double taus_in_block = 6;
constexpr std::size_t density_histogram_bins = 40;
/// A bin of the map is computed from this many samples on.
constexpr double fewest_in_map_bin = 50;

double mean_of(std::span<double const> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double deviation_of(std::span<double const> values, double mean) {
  double sum = 0;
  for (double x : values)
    sum += (x - mean) * (x - mean);
  return std::sqrt(sum / double(values.size()));
}

/// Equal bins of [low, high).
struct Bins {
  double low = 0, high = 1;
  std::size_t count = 1;

  double width() const { return (high - low) / double(count); }
  double centre(std::size_t bin) const { return low + (double(bin) + 0.5) * width(); }
  /// `count` when the value lies outside.
  std::size_t of(double value) const {
    if (!(value >= low && value < high))
      return count;
    return std::min(count - 1, std::size_t((value - low) / width()));
  }
};

/// Sums of one block over single molecules.
enum Moment : std::size_t { n, P2, P4, K, K2, U, U2, KU, moments };

struct Block {
  Sums moments = Sums(Moment::moments, 0.0);
  Sums P_x, P_U; ///< the last entry is the number of samples
  Sums map;      ///< counts K x U, the last entry is the number of samples
};

/// What is measured of single molecules, and how it becomes results.
class Singles {
 public:
  Singles(BlobSeries const& series, CorrelationSettings const& settings)
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

  Block block(std::pair<std::size_t, std::size_t> frames) const {
    Block result;
    result.P_x.assign(P_bins_.count + 1, 0.0);
    result.P_U.assign(U_bins_.count + 1, 0.0);
    result.map.assign(map_K_.count * map_U_.count + 1, 0.0);
    for (std::size_t k = frames.first * series_.molecules; k < frames.second * series_.molecules; ++k)
      add(k, result);
    return result;
  }

  void moments_into(std::vector<Block> const& blocks, Correlations& out) const {
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

  void densities_into(std::vector<Block> const& blocks, Correlations& out) const {
    out.P_x = density(column(blocks, &Block::P_x), P_bins_);
    out.P_U = density(column(blocks, &Block::P_U), U_bins_);
  }

  RelativeErrorMap map(std::vector<Block> const& blocks) const {
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

 private:
  static std::vector<Sums> column(std::vector<Block> const& blocks, Sums Block::*member) {
    std::vector<Sums> result;
    for (auto const& block : blocks)
      result.push_back(block.*member);
    return result;
  }

  void add(std::size_t k, Block& block) const {
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

  static Profile density(std::vector<Sums> const& sums, Bins const& bins) {
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

  /// 1 - P(K)P(U)/P(K,U) within the grid; 0 where nothing was seen.
  std::vector<double> relative_errors(Sums const& s) const {
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

  BlobSeries const& series_;
  double U_shift_, U_spread_;
  Bins P_bins_, U_bins_, map_K_, map_U_;
};

std::vector<double> momentum_components(BlobSeries const& series) {
  std::vector<double> components; // three times as many molecules
  for (auto const& p : series.P)
    components.insert(components.end(), {p.x, p.y, p.z});
  return components;
}

/// Independent K and U at a fixed total energy: the covariance of two parts is minus the product of their
/// heat capacities over that of all.
double expected_C_KU(BlobSeries const& series, Correlations const& found) {
  double const c_K = 1.5, c_U = found.beta.mean * found.beta.mean * found.U_variance.mean;
  return -std::sqrt(c_K * c_U) / ((c_K + c_U) * double(series.molecules));
}

KeyTest test_of(std::string name, Estimate const& found, double expected, std::string statement) {
  return {.name = std::move(name),
          .deviation = {found.mean - expected, found.se, found.n_eff},
          .in_se = deviation(found, expected),
          .statement = std::move(statement)};
}

/// The bin of a profile that is farthest from 0 in standard errors, among those from x_low on.
KeyTest worst_bin(std::string name, Profile const& profile, double x_low, double expected,
                  std::string const& axis) {
  KeyTest worst{.name = std::move(name), .deviation = {}, .in_se = 0, .statement = ""};
  std::size_t bins = 0, beyond_3 = 0;
  double chi_2 = 0;
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    auto const& y = profile.y[k];
    if (profile.x[k] < x_low || !(y.se > 0))
      continue;
    double const z = (y.mean - expected) / y.se;
    ++bins, beyond_3 += std::abs(z) > 3, chi_2 += z * z;
    if (std::abs(z) > std::abs(worst.in_se)) {
      worst.deviation = {y.mean - expected, y.se, y.n_eff};
      worst.in_se = z;
      worst.statement = fmt::format("the farthest bin is at {} = {:.3g}", axis, profile.x[k]);
    }
  }
  worst.statement += fmt::format("; {} of {} bins are off by more than 3 standard errors, chi^2 a bin {:.2f}",
                                 beyond_3, bins, bins ? chi_2 / double(bins) : 0.0);
  return worst;
}

void add_tests(Correlations& c) {
  c.tests.push_back(test_of("P_x is Maxwellian", c.kurtosis, 0, "excess of <P^4>/(3 <P^2>^2) over 1"));
  c.tests.push_back(test_of("C_KU = 0", c.C_KU, c.C_KU_expected,
                            fmt::format("the fixed total energy alone makes {:.1e}", c.C_KU_expected)));
  double const excess =
      std::max(0.0, c.map.typical * c.map.typical - c.map.typical_from_noise * c.map.typical_from_noise);
  double const blocks = double(c.blocks);
  c.tests.push_back({.name = "P(K,U) = P(K)P(U)",
                     .deviation = {std::sqrt(excess), c.map.typical_from_noise, blocks},
                     .in_se = c.map.typical_from_noise > 0 ? std::sqrt(excess) / c.map.typical_from_noise : 0,
                     .statement = fmt::format("typical relative error {:.3g}, of which noise makes {:.3g}",
                                              c.map.typical, c.map.typical_from_noise)});
  c.tests.push_back(worst_bin("u(r) = g(r) beyond contact", c.pair_energy, c.contact, 1, "r"));
  c.tests.push_back(test_of("<U1 U2>^r = <U>^2 at contact", c.contact_energy, 1,
                            fmt::format("pairs nearer than {:.3g}", c.contact)));
  c.tests.push_back(test_of("C_UD = 0", c.C_UD, 0, "intrinsic energy against local density"));
  c.tests.push_back(worst_bin("<U>^rho = <U>", c.U_of_density, -1, 0, "rho"));
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
  if (possible < double(fewest_blocks))
    throw PhysicsError(
        fmt::format("the run of {:.4g} time units is too short for standard errors: its longest "
                    "autocorrelation time is {:.3g} (P {:.3g}, U {:.3g}, local density {:.3g}), so "
                    "at least {:.4g} are needed",
                    all_time, longest, result.tau_P.tau, result.tau_U.tau, result.tau_rho.tau,
                    taus_in_block * longest * double(fewest_blocks)));
  result.blocks = std::min(most_blocks, std::size_t(possible));
  result.block_time = all_time / double(result.blocks);

  Singles const singles(series, settings);
  std::vector<Block> blocks;
  auto const borders = time_blocks(series.frames(), result.blocks);
  for (auto const& frames : borders)
    blocks.push_back(singles.block(frames));
  singles.moments_into(blocks, result);
  singles.densities_into(blocks, result);
  result.map = singles.map(blocks);
  result.C_KU_expected = expected_C_KU(series, result);
  pairs.results_into(borders, result);

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
  add_tests(result);
  return result;
}

double lucy(double r, double h) {
  double const x = r / h, rest = 1 - x;
  return x < 1 ? 105 / (16 * std::numbers::pi * h * h * h) * (1 + 3 * x) * rest * rest * rest : 0;
}

} // namespace mesobridge::cg
