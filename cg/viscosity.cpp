#include "cg/viscosity.hpp"
#include "cg/jackknife.hpp"
#include "cg/own_motion.hpp"
#include "cg/transverse_currents.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {
namespace {

constexpr double fitted_down_to = 0.2; // of C(t)/C(0)
constexpr std::size_t least_fitted = 5;
constexpr std::size_t fewest_blocks = 8, usual_blocks = 16;
constexpr double shown_beyond = 2; // lags of the correlation that are kept, in fitted ones

void check(BlobSeries const& series, ViscositySettings const& settings) {
  cg::check(settings);
  require(series.molecules >= 16, "molecules", series.molecules, "at least 16 are needed for a viscosity");
  auto const least = 8 * std::max(settings.blocks, fewest_blocks);
  require(series.frames() >= least, "frames", series.frames(),
          fmt::format("at least {} are needed for a viscosity, 8 in each block", least));
  require_equal_intervals(series);
}

/// Of each block the sums of x(s) x(s+t), s in the block, for every lag up to `last`, then their numbers.
std::vector<Sums> products_in_blocks(Currents const& currents, std::size_t blocks, std::size_t last) {
  std::size_t const frames = currents.front().size(), lags = last + 1;
  std::vector<Sums> result;
  for (auto const& [begin, end] : time_blocks(frames, blocks)) {
    Sums sums(2 * lags, 0.0);
    for (auto const& x : currents)
      for (std::size_t lag = 0; lag < lags; ++lag) {
        double sum = 0;
        for (std::size_t s = begin; s < end && s + lag < frames; ++s)
          sum += x[s] * x[s + lag];
        sums[lag] += sum;
      }
    for (std::size_t lag = 0; lag < lags; ++lag)
      sums[lags + lag] = double(std::min(end, frames - lag) - std::min(begin, frames - lag));
    result.push_back(std::move(sums));
  }
  return result;
}

double mean_product(Sums const& sums, std::size_t lag, std::size_t lags) {
  return sums[lag] / sums[lags + lag];
}

/// The waves of one length, block by block; the lags of the fit are those of the whole run.
struct Decaying {
  WaveShell shell;
  std::vector<Sums> blocks;
  std::size_t lags = 0, fitted = 0, kept = 0;
  double per_component = 0; ///< mass and number of currents: of C(0), makes k_B T

  /// C(t)/C(0) of as many lags as are wanted.
  std::vector<double> correlation(Sums const& sums, std::size_t count) const {
    std::vector<double> C(count);
    for (std::size_t lag = 0; lag < count; ++lag)
      C[lag] = mean_product(sums, lag, lags) / mean_product(sums, 0, lags);
    return C;
  }
};

Sums added(std::vector<Sums> const& blocks) {
  Sums all(blocks.front().size(), 0.0);
  for (auto const& block : blocks)
    std::transform(block.begin(), block.end(), all.begin(), all.begin(), std::plus<>());
  return all;
}

/// Why the waves cannot be used; empty: they can. Sets the lags of their fit.
std::string find_lags(Decaying& waves, Sums const& all) {
  std::size_t lag = 1;
  while (lag < waves.lags && mean_product(all, lag, waves.lags) > fitted_down_to * all[0] / all[waves.lags])
    ++lag;
  waves.fitted = lag + 1;
  if (lag == waves.lags)
    return "the run is too short for them: they have not died away to 0.2 within half a block";
  if (waves.fitted < least_fitted)
    return fmt::format("frames are too far apart: they die away to 0.2 within {}; write frames more often",
                       lag);
  waves.kept = std::min(waves.lags, std::size_t(shown_beyond * double(waves.fitted)));
  return {};
}

/// In as many blocks, with lags up to half of one of `blocks_of_lags` blocks.
Decaying decaying(Currents const& currents, std::size_t blocks, std::size_t blocks_of_lags) {
  std::size_t const last = currents.front().size() / blocks_of_lags / 2;
  return {.shell = {}, .blocks = products_in_blocks(currents, blocks, last), .lags = last + 1};
}

/// As many blocks as leave each twice as long as the fitted lags of the slowest wave that can be used.
std::size_t fitting_blocks(std::vector<Currents> const& currents) {
  std::size_t longest = 1;
  for (auto const& of_one_length : currents)
    if (auto waves = decaying(of_one_length, 1, fewest_blocks); find_lags(waves, waves.blocks[0]).empty())
      longest = std::max(longest, waves.fitted);
  return std::clamp(currents.front().front().size() / (2 * longest), fewest_blocks, usual_blocks);
}

/// The integral of C, whose values after the fitted ones are those of the fit.
double integral(std::span<double const> C, ViscousDecay const& decay, double interval) {
  double beside = 0; // of C - fit, by the trapezoidal rule
  for (std::size_t lag = 0; lag < C.size(); ++lag)
    beside += (lag == 0 || lag + 1 == C.size() ? 0.5 : 1) * (C[lag] - decay(double(lag) * interval));
  return 1 / decay.rate + interval * beside;
}

/// Of one length of waves: eta, eta by the integral, k_B T, then the correlation.
std::vector<double> numbers_of(Decaying const& waves, Sums const& sums, double density, double interval) {
  auto const C = waves.correlation(sums, waves.kept);
  auto const fitted = std::span(C).first(waves.fitted);
  auto const decay = fit_viscous_decay(fitted, interval);
  double const inertia = density / (waves.shell.k * waves.shell.k);
  std::vector<double> numbers{inertia * decay.rate, inertia / integral(fitted, decay, interval),
                              mean_product(sums, 0, waves.lags) / waves.per_component};
  numbers.insert(numbers.end(), C.begin(), C.end());
  return numbers;
}

/// eta(k) = eta + slope k^2 by least squares with the given weights.
struct Line {
  double at_zero = 0, slope = 0;
};
Line line_through(std::span<double const> k2, std::span<double const> eta, std::span<double const> weight) {
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t s = 0; s < k2.size(); ++s) {
    w += weight[s], x += weight[s] * k2[s], y += weight[s] * eta[s];
    xx += weight[s] * k2[s] * k2[s], xy += weight[s] * k2[s] * eta[s];
  }
  double const slope = (w * xy - x * y) / (w * xx - x * x);
  return {(y - slope * x) / w, slope};
}

WaveViscosity wave_of(Decaying const& waves, std::vector<Estimate> const& numbers, double interval) {
  auto const C = waves.correlation(added(waves.blocks), waves.kept);
  auto const decay = fit_viscous_decay(std::span(C).first(waves.fitted), interval);
  return {.k = waves.shell.k,
          .vectors = waves.shell.vectors.size(),
          .eta = numbers[0],
          .eta_integral = numbers[1],
          .memory = decay.memory,
          .temperature = numbers[2],
          .correlation = {numbers.begin() + 3, numbers.end()},
          .fitted = waves.fitted,
          .decay = decay};
}

/// The shells whose decay the run shows; the reasons of the others go into `found`.
std::vector<Decaying> usable_waves(BlobSeries const& series, ViscositySettings const& settings,
                                   Viscosity& found) {
  auto const shells = wave_shells(series.boxes.front(), settings.reach);
  auto const currents = transverse_currents(series, shells);
  std::size_t const blocks = settings.blocks > 0 ? settings.blocks : fitting_blocks(currents);
  std::vector<Decaying> usable;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    auto waves = decaying(currents[s], blocks, blocks);
    waves.shell = shells[s];
    waves.per_component = 0.5 * series.mass * double(series.molecules) * double(currents[s].size());
    auto const reason = find_lags(waves, added(waves.blocks));
    if (reason.empty())
      usable.push_back(std::move(waves));
    else
      found.left_out.push_back(fmt::format("k = {:.4g}: {}", shells[s].k, reason));
  }
  if (usable.size() < 2)
    throw InputError(fmt::format("at least two lengths of waves are needed for a viscosity: {}",
                                 fmt::join(found.left_out, "; ")));
  return usable;
}

/// The line through the waves with its jackknife error: all of them together, block by block.
Estimate extrapolated(std::vector<Decaying> const& usable, std::vector<double> const& k2,
                      std::vector<double> const& weight, std::size_t which, Viscosity const& found) {
  std::size_t const blocks = usable.front().blocks.size();
  std::vector<std::vector<Sums>> without; // of each shell: each block left out, then none
  for (auto const& waves : usable)
    without.push_back(without_each(waves.blocks));
  std::vector<double> results;
  for (std::size_t b = 0; b <= blocks; ++b) {
    std::vector<double> eta;
    for (std::size_t s = 0; s < usable.size(); ++s)
      eta.push_back(numbers_of(usable[s], without[s][b], found.density, found.interval)[which]);
    results.push_back(line_through(k2, eta, weight).at_zero);
  }
  return jackknifed(results.back(), std::span(results).first(blocks));
}

} // namespace

void check(ViscositySettings const& settings) {
  require(settings.blocks == 0 || settings.blocks >= fewest_blocks, "blocks of the run", settings.blocks,
          "must be at least 8");
  require(settings.reach >= 1 && settings.reach <= 6, "longest wave vector, in shortest ones", settings.reach,
          "must be 1 ... 6");
}

Viscosity viscosity(BlobSeries const& series, ViscositySettings const& settings) {
  check(series, settings);
  Viscosity found;
  found.interval = series.interval();
  found.density = series.mass * double(series.molecules) / series.boxes.front().volume();
  auto const usable = usable_waves(series, settings, found);
  std::vector<double> k2, eta, weight, weight_integral;
  for (auto const& waves : usable) {
    auto const numbers = jackknife(waves.blocks, [&](Sums const& sums) {
      return numbers_of(waves, sums, found.density, found.interval);
    });
    found.waves.push_back(wave_of(waves, numbers, found.interval));
    auto const& wave = found.waves.back();
    k2.push_back(wave.k * wave.k), eta.push_back(wave.eta.mean);
    weight.push_back(1 / (wave.eta.se * wave.eta.se));
    weight_integral.push_back(1 / (wave.eta_integral.se * wave.eta_integral.se));
  }
  found.eta = extrapolated(usable, k2, weight, 0, found);
  found.eta_integral = extrapolated(usable, k2, weight_integral, 1, found);
  auto const line = line_through(k2, eta, weight);
  found.slope = line.slope;
  for (std::size_t s = 0; s < k2.size(); ++s)
    found.chi2 += weight[s] * std::pow(eta[s] - line.at_zero - line.slope * k2[s], 2);
  return found;
}

} // namespace mesobridge::cg
