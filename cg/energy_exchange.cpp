#include "cg/energy_exchange.hpp"
#include "cg/decay_lag.hpp"
#include "cg/jackknife.hpp"
#include "cg/own_motion.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {
namespace {

/// Lags in frames.
struct Lags {
  std::size_t last, from, to;
};

double half_edge(BlobSeries const& series) {
  double narrowest = series.boxes.front().narrowest();
  for (auto const& box : series.boxes)
    narrowest = std::min(narrowest, box.narrowest());
  return narrowest / 2;
}

void check(BlobSeries const& series, ExchangeSettings const& settings) {
  require(series.molecules >= 4, "molecules", series.molecules, "at least 4 are needed");
  require(settings.blocks >= 4, "blocks of frames", settings.blocks, "must be at least 4");
  require(series.frames() >= 8 * settings.blocks, "frames", series.frames(),
          fmt::format("at least {} are needed", 8 * settings.blocks));
  require_equal_intervals(series);
  double const half = half_edge(series);
  require(settings.cutoff >= 0 && settings.cutoff < 0.9 * half, "cut-off", settings.cutoff,
          fmt::format("must be above 0 and below {:.4g}, so that there are molecules beyond it", 0.9 * half));
  require(settings.width > 0 && settings.width <= half / 8, "bin width", settings.width,
          fmt::format("must be above 0 and at most {:.4g}", half / 8));
}

/// Energies less their mean over all molecules and frames, each molecule's one after another in time.
std::vector<double> deviations(BlobSeries const& series) {
  std::size_t const N = series.molecules, n = series.frames();
  double const mean = std::accumulate(series.U.begin(), series.U.end(), 0.0) / double(series.U.size());
  std::vector<double> dU(N * n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t m = 0; m < N; ++m)
      dU[m * n + k] = series.U[k * N + m] - mean;
  return dU;
}

/// The lag in frames at which the correlation of all molecules together, within a block, has come to 1/e.
double rough_decay(BlobSeries const& series, std::vector<double> const& dU, std::size_t blocks) {
  std::size_t const n = series.frames(), lags = n / blocks;
  std::vector<double> sum(lags, 0.0);
  for (std::size_t m = 0; m < series.molecules; ++m)
    std::ranges::transform(sum, autocovariance(std::span(dU).subspan(m * n, n), lags - 1), sum.begin(),
                           std::plus<>());
  require(sum[0] > 0, "variance of the internal energies", sum[0], "must be > 0: these blobs have none");
  return decay_lag(lags, [&](std::size_t lag) { return sum[lag]; });
}

Lags lags_of(BlobSeries const& series, ExchangeSettings const& settings, double decay) {
  double const interval = series.interval();
  auto const frames = [&](double time, double usual) {
    return std::size_t(std::lround(time > 0 ? time / interval : usual));
  };
  Lags lags{0, frames(settings.from, 1), frames(settings.to, 0.4 * decay)};
  require(settings.to > 0 || lags.to >= lags.from + 3, "interval of frames", interval,
          fmt::format("must be at most {:.2g}, a tenth of the time in which internal energies decay",
                      0.1 * decay * interval));
  require(lags.to >= lags.from + 3, "lags of the parabolas",
          fmt::format("{:g} ... {:g}", settings.from, settings.to),
          fmt::format("must hold at least 4 frames, {:g} apart", interval));
  lags.last = std::max(lags.to, frames(settings.longest, 2 * decay));
  require(series.frames() > settings.blocks * lags.last, "longest lag", interval * double(lags.last),
          fmt::format("must be below {:.4g}, the length of a block; make a longer run",
                      interval * double(series.frames()) / double(settings.blocks)));
  return lags;
}

/// The sums of one block of frames: rows of products at all lags, then what they are over; first each
/// molecule's own, then those of strangers, then a row a bin, whose distances are summed too.
class Rows {
 public:
  Rows(std::size_t lags, std::size_t bins) : lags_(lags), sums_((bins + 2) * (lags + 2), 0.0) {}
  static constexpr std::size_t own = 0, strangers = 1, first_bin = 2;

  void add(std::size_t row, double const* a, double const* b) {
    double* const sums = &sums_[row * (lags_ + 2)];
    for (std::size_t lag = 0; lag < lags_; ++lag)
      sums[lag] += a[0] * b[lag];
    sums[lags_] += 1;
  }
  void add_distance(std::size_t row, double r) { sums_[row * (lags_ + 2) + lags_ + 1] += r; }
  Sums const& sums() const { return sums_; }

 private:
  std::size_t lags_;
  Sums sums_;
};

/// What the sums of some blocks say.
struct Told {
  Sums const& sums;
  std::size_t lags;

  double count(std::size_t row) const { return sums[row * (lags + 2) + lags]; }
  double distance(std::size_t row) const { return sums[row * (lags + 2) + lags + 1] / count(row); }
  double mean(std::size_t row, std::size_t lag) const { return sums[row * (lags + 2) + lag] / count(row); }
  /// Without what strangers have in common.
  double net(std::size_t row, std::size_t lag) const { return mean(row, lag) - mean(Rows::strangers, lag); }
  /// At lag 0 of the parabola of least squares, per frame.
  double slope(std::size_t row, Lags const& of) const {
    double const middle = 0.5 * double(of.from + of.to);
    double m2 = 0, m4 = 0, y0 = 0, y1 = 0, y2 = 0,
           n = 0; // x is from the middle on, so that odd moments vanish
    for (std::size_t lag = of.from; lag <= of.to; ++lag) {
      double const x = double(lag) - middle, y = net(row, lag);
      n += 1, m2 += x * x, m4 += x * x * x * x, y0 += y, y1 += x * y, y2 += x * x * y;
    }
    double const curvature = (n * y2 - m2 * y0) / (n * m4 - m2 * m2);
    return y1 / m2 - 2 * curvature * middle;
  }
  double decay() const {
    return decay_lag(lags, [&](std::size_t lag) { return net(Rows::own, lag); });
  }
};

Sums sums_of_block(BlobSeries const& series, std::vector<double> const& dU, ExchangeSettings const& settings,
                   double cutoff, std::size_t bins, std::size_t lags,
                   std::pair<std::size_t, std::size_t> frames) {
  std::size_t const N = series.molecules, n = series.frames();
  double const half = half_edge(series);
  Rows rows(lags, bins);
  for (std::size_t k = frames.first; k < std::min(frames.second, n - lags + 1); ++k) {
    auto const& box = series.boxes[k];
    for (std::size_t a = 0; a < N; ++a) {
      double const* const of_a = &dU[a * n + k];
      rows.add(Rows::own, of_a, of_a);
      for (std::size_t b = a + 1; b < N; ++b) {
        double const r = norm(box.minimum_image(series.R[k * N + a] - series.R[k * N + b]));
        if (r >= half)
          continue;
        std::size_t const row = r >= cutoff
                                    ? Rows::strangers
                                    : Rows::first_bin + std::min(bins - 1, std::size_t(r / settings.width));
        double const* const of_b = &dU[b * n + k];
        rows.add(row, of_a, of_b), rows.add(row, of_b, of_a);
        rows.add_distance(row, 2 * r);
      }
    }
  }
  return rows.sums();
}

/// Bins whose pairs are in every block.
std::vector<std::size_t> filled_rows(std::vector<Sums> const& blocks, std::size_t lags, std::size_t bins) {
  std::vector<std::size_t> rows;
  for (std::size_t row = Rows::first_bin; row < Rows::first_bin + bins; ++row)
    if (std::ranges::all_of(blocks, [&](Sums const& sums) { return Told{sums, lags}.count(row) > 0; }))
      rows.push_back(row);
  return rows;
}

} // namespace

EnergyExchange energy_exchange(BlobSeries const& series, ExchangeSettings const& settings) {
  check(series, settings);
  auto const dU = deviations(series);
  auto const of = lags_of(series, settings, rough_decay(series, dU, settings.blocks));
  double const interval = series.interval(),
               cutoff = settings.cutoff > 0 ? settings.cutoff : 2 * half_edge(series) / 3;
  std::size_t const lags = of.last + 1, bins = std::size_t(std::ceil(cutoff / settings.width - 1e-9));
  std::vector<Sums> blocks;
  for (auto const& frames : time_blocks(series.frames(), settings.blocks))
    blocks.push_back(sums_of_block(series, dU, settings, cutoff, bins, lags, frames));
  Sums all(blocks.front().size(), 0.0);
  for (auto const& block : blocks)
    std::ranges::transform(all, block, all.begin(), std::plus<>());
  Told const whole{all, lags};
  require(whole.count(Rows::strangers) > 0, "cut-off", cutoff, "leaves no molecules beyond it");
  auto const rows = filled_rows(blocks, lags, bins);
  auto const estimates = jackknife(blocks, [&](Sums const& sums) {
    Told const told{sums, lags};
    std::vector<double> numbers{told.net(Rows::own, 0), told.decay() * interval,
                                -told.slope(Rows::own, of) / interval, 0};
    for (std::size_t lag = 0; lag < lags; ++lag)
      numbers.push_back(told.net(Rows::own, lag) / told.net(Rows::own, 0));
    for (std::size_t const row : rows) {
      double const flow = told.slope(row, of) / interval;
      numbers[3] += flow * told.count(row) / told.count(Rows::own);
      numbers.push_back(flow);
      for (std::size_t lag = 0; lag < lags; ++lag)
        numbers.push_back(told.net(row, lag));
    }
    return numbers;
  });
  EnergyExchange found{.lag = {},
                       .variance = estimates[0],
                       .own = {},
                       .decay = {},
                       .from = double(of.from) * interval,
                       .to = double(of.to) * interval,
                       .cutoff = cutoff,
                       .loss = estimates[2],
                       .bins = {},
                       .gain = estimates[3]};
  if (whole.decay() < double(of.last))
    found.decay = estimates[1];
  for (std::size_t lag = 0; lag < lags; ++lag) {
    found.lag.push_back(double(lag) * interval);
    found.own.push_back(estimates[4 + lag]);
  }
  auto next = estimates.begin() + std::ptrdiff_t(4 + lags);
  for (std::size_t const row : rows) {
    EnergyExchange::Bin bin{.r = whole.distance(row),
                            .neighbours = whole.count(row) / whole.count(Rows::own),
                            .together = {},
                            .flow = *next++};
    bin.together.assign(next, next + std::ptrdiff_t(lags));
    next += std::ptrdiff_t(lags);
    found.bins.push_back(std::move(bin));
  }
  return found;
}

} // namespace mesobridge::cg
