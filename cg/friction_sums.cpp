#include "cg/friction_sums.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {
namespace {

constexpr double plateau_in_memories = 8, longest_in_plateaus = 4, run_in_plateaus = 20;
constexpr double least_resolved = 0.5; // of the correlation after one interval

/// Where one configuration's sums stand: k_B T, its own number, the correlation of a molecule's forces of
/// each lag, those of pairs along, whole, and the counts of pairs.
class Layout {
 public:
  Layout(std::size_t lags, std::size_t bins) : lags(lags), bins(bins) {}
  std::size_t const lags, bins;

  double kT(Sums const& s) const { return s[0] / s[1]; }
  double configurations(Sums const& s) const { return s[1]; }
  double const* self(Sums const& s) const { return s.data() + 2; }
  double const* along(Sums const& s, std::size_t bin) const { return s.data() + 2 + lags * (1 + bin); }
  double const* whole(Sums const& s, std::size_t bin) const { return s.data() + 2 + lags * (1 + bins + bin); }
  std::vector<double> count(Sums const& s) const {
    return {s.begin() + std::ptrdiff_t(2 + lags * (1 + 2 * bins)), s.end()};
  }
};

/// The integrals up to each lag by the trapezoidal rule, freed from what the mean over the run has taken off
/// (Eq. (C26)).
std::vector<double> integrals(double const* correlation, ForceLags const& lags) {
  std::vector<double> sums(lags.last + 1);
  for (std::size_t k = 1; k <= lags.last; ++k)
    sums[k] = sums[k - 1] + 0.5 * lags.interval * (correlation[k - 1] + correlation[k]);
  double const share = 2 * double(lags.plateau) * lags.interval / lags.time_held,
               whole = sums[lags.plateau] / (1 - share);
  for (std::size_t k = 0; k <= lags.last; ++k)
    sums[k] += whole * 2 * double(k) * lags.interval / lags.time_held;
  return sums;
}

/// The mean correlation of a molecule's forces, over as many lags as the run may be long plateaus.
std::vector<double> self_correlation(std::vector<HeldConfiguration> const& all, std::size_t last) {
  std::vector<double> mean(last + 1);
  for (auto const& one : all) {
    auto const self = ForceSpectra(one, last).self();
    for (std::size_t k = 0; k <= last; ++k)
      mean[k] += self[k] / double(all.size());
  }
  return mean;
}

/// The memory time: the integral ends at the first lag beyond its 8 times.
double memory_of(std::vector<double> const& correlation, double interval) {
  double sum = 0.5;
  for (std::size_t k = 1; k < correlation.size(); ++k) {
    sum += correlation[k] / correlation[0];
    if (double(k) > plateau_in_memories * sum)
      break;
  }
  return sum * interval;
}

} // namespace

ForceLags force_lags(std::vector<HeldConfiguration> const& all, double interval, double plateau) {
  std::size_t const frames = all[0].F.size() / all[0].R.size(), most = frames / 4;
  auto const correlation = self_correlation(all, most);
  require(correlation[0] > 0, "mean square force on a molecule", correlation[0], "must be > 0");
  require(correlation[1] > least_resolved * correlation[0], "correlation of forces after one interval",
          correlation[1] / correlation[0],
          fmt::format("must be above {}: take frames more often (--sample-every)", least_resolved));
  ForceLags lags{.interval = interval,
                 .time_held = double(frames) * interval,
                 .memory = memory_of(correlation, interval)};
  if (plateau == 0)
    plateau = plateau_in_memories * lags.memory;
  lags.plateau = std::max<std::size_t>(1, std::size_t(std::lround(plateau / interval)));
  require(run_in_plateaus * plateau <= lags.time_held, "time that a configuration is held", lags.time_held,
          fmt::format("must be at least {:.4g}, {} times that of the plateau, {:.4g}",
                      run_in_plateaus * plateau, run_in_plateaus, plateau));
  lags.last = std::min(most, std::size_t(longest_in_plateaus) * lags.plateau);
  return lags;
}

Sums friction_sums(HeldConfiguration const& one, ForceLags const& lags, std::size_t bins, double bin_width) {
  ForceSpectra const spectra(one, lags.last);
  auto const pairs = spectra.pairs(bin_width, bins);
  Sums sums{one.kT, 1};
  for (auto const& part : {spectra.self(), pairs.along, pairs.whole, pairs.count})
    sums.insert(sums.end(), part.begin(), part.end());
  return sums;
}

FrictionFromSums friction_from(Sums const& sums, ForceLags const& lags, std::size_t bins, double bin_width,
                               std::size_t molecules) {
  Layout const layout(lags.last + 1, bins);
  double const n = layout.configurations(sums);
  FrictionFromSums found;
  found.kT = layout.kT(sums);
  double const kT = found.kT;
  found.self = integrals(layout.self(sums), lags);
  double const mean_square = 2 * found.self[lags.plateau] / n / lags.time_held; // of the mean force
  found.variance = layout.self(sums)[0] / n + mean_square;
  for (std::size_t k = 0; k <= lags.last; ++k)
    found.correlation.push_back((layout.self(sums)[k] / n + mean_square) / found.variance);
  for (double& value : found.self)
    value /= n * kT;
  auto& at = found.at_plateau;
  at = {
      .width = bin_width, .fine = PairCorrelations::fine, .par = {}, .perp = {}, .count = layout.count(sums)};
  at.molecules = n * double(molecules), at.self = found.self[lags.plateau];
  for (std::size_t bin = 0; bin < layout.bins; ++bin) {
    double const pairs = std::max(1.0, at.pairs(bin));
    auto par = integrals(layout.along(sums, bin), lags), perp = integrals(layout.whole(sums, bin), lags);
    for (std::size_t k = 0; k <= lags.last; ++k)
      perp[k] = -0.5 * (perp[k] - par[k]) / (pairs * kT), par[k] /= -pairs * kT;
    at.par.push_back(par[lags.plateau]), at.perp.push_back(perp[lags.plateau]);
    found.par.push_back(std::move(par)), found.perp.push_back(std::move(perp));
  }
  return found;
}

} // namespace mesobridge::cg
