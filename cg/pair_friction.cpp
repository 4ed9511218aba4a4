#include "cg/pair_friction.hpp"
#include "cg/friction_sums.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {
namespace {

constexpr double told_from_zero = 2; // standard errors

void check(std::vector<HeldConfiguration> const& all, FrictionSettings const& settings) {
  require(all.size() >= 4, "whole configurations", all.size(),
          "at least 4 are needed for standard errors: make more (--configurations)");
  std::size_t const molecules = all[0].R.size(), forces = all[0].F.size();
  require(molecules >= 4, "molecules", molecules, "at least 4 are needed");
  require(forces / molecules >= 64, "frames of a configuration", forces / molecules,
          "at least 64 are needed: hold it longer");
  for (auto const& one : all) {
    require(one.R.size() == molecules, "molecules of a configuration", one.R.size(),
            fmt::format("must be {} in each", molecules));
    require(one.F.size() == forces, "frames of a configuration", double(one.F.size()) / double(molecules),
            fmt::format("must be {} in each", forces / molecules));
    require(one.kT > 0 && std::isfinite(one.kT), "temperature of a configuration", one.kT, "must be > 0");
  }
  require(settings.interval > 0, "interval of frames", settings.interval, "must be > 0");
  require(settings.plateau >= 0 && std::isfinite(settings.plateau), "time of the plateau", settings.plateau,
          "must be >= 0");
  require(settings.cutoff >= 0 && std::isfinite(settings.cutoff), "cut-off of the friction", settings.cutoff,
          "must be > 0");
  require(settings.knots > 0 && std::isfinite(settings.knots), "distance of knots", settings.knots,
          "must be > 0");
}

std::size_t bins_of(std::vector<HeldConfiguration> const& all, double width) {
  double half = all[0].box.narrowest() / 2;
  for (auto const& one : all)
    half = std::min(half, one.box.narrowest() / 2);
  require(width >= 1e-3 * half && 4 * width <= half, "width of the bins", width,
          fmt::format("4 to 1000 of them must be within half of the box, {:.4g}", half));
  return std::size_t(half / width * (1 + 1e-12));
}

/// One bin beyond the outermost two neighbours whose frictions along can be told from zero, so that there is
/// room to go to zero in. All pairs have about the same noise: the errors of all bins say together what that
/// of one is.
double usual_cutoff(MeasuredFriction const& at, std::vector<FrictionBin> const& bins) {
  double noise = 0;
  for (auto const& bin : bins)
    noise += bin.par.se * bin.par.se * bin.pairs / double(bins.size());
  auto const told = [&](std::size_t bin) {
    double const pairs = at.pairs(bin);
    return pairs > 0 && at.par[bin] > told_from_zero * std::sqrt(noise / pairs);
  };
  for (std::size_t bin = at.par.size(); bin > 1; --bin)
    if (told(bin - 1) && told(bin - 2))
      return double(std::min(bin + 1, at.par.size())) * at.width;
  throw PhysicsError("no friction of pairs can be told from noise: hold more configurations, or for longer");
}

/// Numbers of one statistic after the other, as jackknife wants and gives them.
template <class Number>
struct Row {
  std::vector<Number> numbers;
  std::size_t at = 0;

  std::vector<Number> next(std::size_t n) {
    at += n;
    return {numbers.begin() + std::ptrdiff_t(at - n), numbers.begin() + std::ptrdiff_t(at)};
  }
};

std::vector<double> row_of(FrictionFromSums const& found) {
  std::vector<double> row{found.kT, found.variance};
  auto const add = [&](std::vector<double> const& part) { row.insert(row.end(), part.begin(), part.end()); };
  add(found.self), add(found.correlation);
  for (std::size_t bin = 0; bin < found.par.size(); ++bin)
    add(found.par[bin]), add(found.perp[bin]);
  return row;
}

/// The spread of what the configurations say without each in turn.
Estimate spread(double whole, std::vector<MeasuredFriction> const& without,
                std::function<double(std::size_t)> const& of) {
  std::vector<double> values;
  for (std::size_t k = 0; k < without.size(); ++k)
    values.push_back(of(k));
  return {whole, jackknifed(whole, values).se, double(without.size())};
}

/// What the integral of a molecule's forces gains after the plateau.
Estimate rise_after(std::size_t plateau, std::vector<Sums> const& rests,
                    std::function<FrictionFromSums(Sums const&)> const& from) {
  std::vector<double> values;
  for (auto const& sums : rests) {
    auto const self = from(sums).self;
    values.push_back(self.back() - self[plateau]);
  }
  return jackknifed(values.back(), std::span(values).first(values.size() - 1));
}

void add_errors(PairFriction& result, MeasuredFriction const& whole,
                std::vector<MeasuredFriction> const& without, double knots) {
  double const cutoff = result.table.cutoff();
  result.near = spread(whole.sum(cutoff), without, [&](std::size_t k) { return without[k].sum(cutoff); });
  std::vector<FrictionTable> tables;
  for (auto const& rest : without)
    tables.push_back(friction_table(rest, cutoff, knots));
  for (double const r : result.table.r) {
    result.par_se.push_back(spread(0, without, [&](std::size_t k) { return tables[k].par_at(r); }).se);
    result.perp_se.push_back(spread(0, without, [&](std::size_t k) { return tables[k].perp_at(r); }).se);
  }
}

} // namespace

PairFriction pair_friction(std::vector<HeldConfiguration> const& configurations,
                           FrictionSettings const& settings, std::function<void(std::size_t)> const& done) {
  check(configurations, settings);
  std::size_t const bins = bins_of(configurations, settings.bin_width);
  double const width = settings.bin_width;
  PairFriction result;
  auto const lags = force_lags(configurations, settings.interval, settings.plateau);
  std::vector<Sums> blocks;
  for (auto const& one : configurations) {
    blocks.push_back(friction_sums(one, lags, bins, width));
    done(blocks.size());
  }
  std::size_t const n = lags.last + 1;
  auto const from = [&](Sums const& sums) {
    return friction_from(sums, lags, bins, width, configurations[0].R.size());
  };
  Row<Estimate> row{jackknife(blocks, [&](Sums const& sums) { return row_of(from(sums)); })};
  auto const rests = without_each(blocks);
  auto whole = from(rests.back()).at_plateau;
  result.kT = row.next(1)[0], result.force_variance = row.next(1)[0];
  result.self_integral = row.next(n), result.correlation = row.next(n);
  result.self = result.self_integral[lags.plateau];
  result.rise = rise_after(lags.plateau, rests, from);
  result.memory = lags.memory, result.plateau = double(lags.plateau) * lags.interval,
  result.time_held = lags.time_held;
  result.configurations = configurations.size();
  for (std::size_t k = 0; k <= lags.last; ++k)
    result.lag.push_back(double(k) * lags.interval);
  for (std::size_t bin = 0; bin < bins; ++bin) {
    FrictionBin one{.r = (double(bin) + 0.5) * width, .pairs = whole.pairs(bin), .par = {}, .perp = {}};
    one.par_integral = row.next(n), one.perp_integral = row.next(n);
    one.par = one.par_integral[lags.plateau], one.perp = one.perp_integral[lags.plateau];
    if (one.pairs > 0)
      result.bins.push_back(std::move(one));
  }
  double const cutoff = settings.cutoff > 0 ? settings.cutoff : usual_cutoff(whole, result.bins);
  require(cutoff <= double(bins) * width * (1 + 1e-9), "cut-off of the friction", cutoff,
          fmt::format("must be within half of the box, {:.4g}", double(bins) * width));
  whole.self = result.self.mean;
  result.table = friction_table(whole, cutoff, settings.knots);
  result.table_sum = friction_sum(result.table, whole);
  std::vector<MeasuredFriction> without;
  for (std::size_t k = 0; k + 1 < rests.size(); ++k)
    without.push_back(from(rests[k]).at_plateau);
  add_errors(result, whole, without, settings.knots);
  return result;
}

} // namespace mesobridge::cg
