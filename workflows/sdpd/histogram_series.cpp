#include "workflows/sdpd/histogram_series.hpp"
#include "cg/histogram.hpp"
#include "md/error.hpp"
#include "workflows/scene/quantities.hpp"
#include "workflows/sdpd/last_step.hpp"
#include <algorithm>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::workflows {
namespace {

std::string const root = "histogram";
constexpr double least_width = 1e-9; ///< of all bins, in the values themselves: far above round-off

void append_one(Store& store, std::string const& path, std::int64_t value) {
  store.append(path, std::span<std::int64_t const>(&value, 1));
}

} // namespace

HistogramSeries::HistogramSeries(Store& store, Scene const& scene, OutputUnits const& units)
    : store_(store), bins_(static_cast<std::size_t>(scene.histogram.bins)), reach_(scene.histogram.reach),
      quantities_(chosen(scene.histogram.quantities, histogram_quantities(), scene.features())),
      units_(units), last_step_(workflows::last_step(store, root + "/step")) {}

HistogramSeries::Quantity HistogramSeries::find(std::string const& name, sdpd::Snapshot const& now) const {
  auto const& field = *std::ranges::find(sdpd::fields, name, &sdpd::Field::name);
  auto const [unit, key] = units_.of(field.dimension);
  return {root + "/" + name + key, now.*field.values, unit, field.range};
}

/// Those of the file or, at the first histogram, those of its particles, which are written. They are kept as
/// reduced numbers, too, so that a resumed run counts into the very same bins.
HistogramSeries::Bins HistogramSeries::bins_of(Quantity const& of) {
  if (store_.has_attribute(of.group, "lower_reduced")) {
    double const lower = store_.read_double_attribute(of.group, "lower_reduced");
    return {lower, store_.read_double_attribute(of.group, "upper_reduced", {.above = lower})};
  }
  double const mean = gsl_stats_mean(of.values.data(), 1, of.values.size()),
               sd = gsl_stats_sd_m(of.values.data(), 1, of.values.size(), mean);
  bool const bounded = std::isfinite(of.range.min) && std::isfinite(of.range.max);
  Bins const bins = bounded ? Bins{of.range.min, std::nextafter(of.range.max, 2 * of.range.max)}
                            : Bins{mean - reach_ * sd, mean + reach_ * sd};
  if (!(bins.upper - bins.lower > least_width * std::max(std::abs(bins.lower), std::abs(bins.upper))))
    throw PhysicsError(fmt::format(
        "histogram.quantities = {}: all particles have the value {:.6g} at the first one, so that its bins "
        "have no width; equilibrate first, or name others",
        of.group.substr(root.size() + 1), mean * of.unit));
  std::vector<double> edges(bins_ + 1);
  for (std::size_t b = 0; b <= bins_; ++b)
    edges[b] =
        of.unit * std::lerp(bins.lower, bins.upper, static_cast<double>(b) / static_cast<double>(bins_));
  store_.write(of.group + "/edges", edges);
  store_.set_attribute(of.group, "lower_reduced", bins.lower);
  store_.set_attribute(of.group, "upper_reduced", bins.upper);
  return bins;
}

void HistogramSeries::append(sdpd::Snapshot const& now, std::int64_t step, double time) {
  if (step <= last_step_)
    return;
  for (auto const& name : quantities_) {
    auto const quantity = find(name, now);
    auto const bins = bins_of(quantity);
    auto const histogram = cg::histogram(quantity.values, bins.lower, bins.upper, bins_);
    std::vector<std::int64_t> const counts(histogram.counts.begin(), histogram.counts.end());
    store_.append(quantity.group + "/counts", counts, {counts.size()});
    append_one(store_, quantity.group + "/below", static_cast<std::int64_t>(histogram.below));
    append_one(store_, quantity.group + "/above", static_cast<std::int64_t>(histogram.above));
  }
  store_.append(root + "/time" + units_.time_key, std::span(&time, 1));
  append_one(store_, root + "/step", step);
  last_step_ = step;
  store_.flush();
}

} // namespace mesobridge::workflows
