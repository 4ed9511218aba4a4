#include "cg/energy_exchange.hpp"
#include "cg/jackknife.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mesobridge::cg {
namespace {

/// Lags in frames.
struct Lags {
  std::size_t last, from, to;
};

Lags lags_of(BlobSeries const& series, ExchangeSettings const& settings) {
  double const interval = series.interval();
  auto const frames = [&](double time) { return std::size_t(std::lround(time / interval)); };
  return {frames(settings.longest), frames(settings.from), frames(settings.to)};
}

double half_edge(BlobSeries const& series) {
  auto const& edge = series.boxes.front().edge;
  return 0.5 * std::min({edge.x, edge.y, edge.z});
}

void check(BlobSeries const& series, ExchangeSettings const& settings) {
  require(series.molecules >= 4, "molecules", series.molecules, "at least 4 are needed");
  require(settings.blocks >= 4, "blocks of frames", settings.blocks, "must be at least 4");
  require(series.frames() >= 16, "frames", series.frames(), "at least 16 are needed");
  double const half = half_edge(series), interval = series.interval();
  for (std::size_t k = 1; k < series.frames(); ++k)
    require(std::abs(series.times[k] - series.times[k - 1] - interval) < 1e-6 * interval, "interval of frames",
            series.times[k] - series.times[k - 1], fmt::format("must be {:g} everywhere", interval));
  require(settings.width > 0 && settings.width <= settings.cutoff, "bin width", settings.width,
          "must be > 0 and at most the cut-off");
  require(settings.cutoff > 0 && settings.cutoff < 0.9 * half, "cut-off", settings.cutoff,
          fmt::format("must be above 0 and below {:.4g}, so that there are molecules beyond it", 0.9 * half));
  auto const [last, from, to] = lags_of(series, settings);
  require(from >= 1 && to > from + 1 && to <= last, "lags of the slope",
          fmt::format("{:g} ... {:g}", settings.from, settings.to),
          fmt::format("must be at least {:g} (a frame) and two frames apart, up to the longest lag {:g}", interval,
                      settings.longest));
  require(series.frames() > settings.blocks * last, "longest lag", settings.longest,
          fmt::format("must be below {:.4g}, the length of a block",
                      interval * double(series.frames()) / double(settings.blocks)));
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
  double slope(std::size_t row, Lags const& of, double interval) const {
    double const middle = 0.5 * double(of.from + of.to);
    double up = 0, down = 0;
    for (std::size_t lag = of.from; lag <= of.to; ++lag) {
      double const x = double(lag) - middle;
      up += x * net(row, lag), down += x * x;
    }
    return up / (down * interval);
  }
  /// When the own correlation has come to 1/e, not whole; the last lag where it does not.
  double decay() const {
    double const goal = net(Rows::own, 0) / std::numbers::e;
    for (std::size_t lag = 1; lag < lags; ++lag)
      if (double const now = net(Rows::own, lag), before = net(Rows::own, lag - 1); now < goal)
        return double(lag) - (goal - now) / (before - now);
    return double(lags - 1);
  }
};

Sums sums_of_block(BlobSeries const& series, std::vector<double> const& dU, ExchangeSettings const& settings,
                   std::size_t bins, std::size_t lags, std::pair<std::size_t, std::size_t> frames) {
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
        std::size_t const row =
            r >= settings.cutoff ? Rows::strangers : Rows::first_bin + std::min(bins - 1, std::size_t(r / settings.width));
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
  auto const of = lags_of(series, settings);
  std::size_t const lags = of.last + 1, bins = std::size_t(std::ceil(settings.cutoff / settings.width - 1e-9));
  double const interval = series.interval();
  auto const dU = deviations(series);
  std::vector<Sums> blocks;
  for (auto const& frames : time_blocks(series.frames(), settings.blocks))
    blocks.push_back(sums_of_block(series, dU, settings, bins, lags, frames));
  Sums all(blocks.front().size(), 0.0);
  for (auto const& block : blocks)
    std::ranges::transform(all, block, all.begin(), std::plus<>());
  Told const whole{all, lags};
  require(whole.count(Rows::strangers) > 0, "cut-off", settings.cutoff, "leaves no molecules beyond it");
  require(whole.net(Rows::own, 0) > 0, "variance of the internal energies", whole.net(Rows::own, 0),
          "must be > 0: these blobs have none");
  auto const rows = filled_rows(blocks, lags, bins);
  auto const estimates = jackknife(blocks, [&](Sums const& sums) {
    Told const told{sums, lags};
    std::vector<double> numbers{told.net(Rows::own, 0), told.decay() * interval, -told.slope(Rows::own, of, interval), 0};
    for (std::size_t lag = 0; lag < lags; ++lag)
      numbers.push_back(told.net(Rows::own, lag) / told.net(Rows::own, 0));
    for (std::size_t const row : rows) {
      double const flow = told.slope(row, of, interval);
      numbers[3] += flow * told.count(row) / told.count(Rows::own);
      numbers.push_back(flow);
      for (std::size_t lag = 0; lag < lags; ++lag)
        numbers.push_back(told.net(row, lag));
    }
    return numbers;
  });
  EnergyExchange found{.lag = {}, .variance = estimates[0], .own = {}, .decay = {}, .loss = estimates[2], .bins = {}, .gain = estimates[3]};
  if (whole.decay() < double(of.last))
    found.decay = estimates[1];
  for (std::size_t lag = 0; lag < lags; ++lag) {
    found.lag.push_back(double(lag) * interval);
    found.own.push_back(estimates[4 + lag]);
  }
  auto next = estimates.begin() + std::ptrdiff_t(4 + lags);
  for (std::size_t const row : rows) {
    EnergyExchange::Bin bin{.r = whole.distance(row), .neighbours = whole.count(row) / whole.count(Rows::own), .together = {}, .flow = *next++};
    bin.together.assign(next, next + std::ptrdiff_t(lags));
    next += std::ptrdiff_t(lags);
    found.bins.push_back(std::move(bin));
  }
  return found;
}

} // namespace mesobridge::cg
