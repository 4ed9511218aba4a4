#include "workflows/sdpd/measured_series.hpp"
#include "md/error.hpp"
#include "workflows/scene/driven.hpp"
#include "workflows/scene/quantities.hpp"
#include "workflows/sdpd/last_step.hpp"
#include "workflows/sdpd/short_series.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

std::string const series_group = "series";

std::string dataset_of(sdpd::Measurement const& measured, OutputUnits const& units) {
  return series_group + "/" + dataset_name(measured, units);
}

/// Those of one number have no second dimension.
Store::Shape row_shape(sdpd::Measurement const& measured) {
  auto const count = measured.components.size();
  return count == 1 ? Store::Shape{} : Store::Shape{count};
}

void check(sdpd::Measurement const& measured, std::vector<double> const& values, std::int64_t step) {
  for (std::size_t c = 0; c < values.size(); ++c)
    if (!std::isfinite(values[c]))
      throw PhysicsError(fmt::format("step {}: the measured {}{} is {}", step, measured.name,
                                     measured.components[c], values[c]));
}

} // namespace

std::vector<sdpd::Measurement> measured_in_series(Scene const& scene) {
  std::vector<sdpd::Measurement> measured;
  if (scene.series.every == 0)
    return measured;
  for (auto const& name : chosen(scene.series.quantities, series_quantities(), scene.features())) {
    auto const& found = *std::ranges::find(sdpd::measurements(), name, &sdpd::Measurement::name);
    bool const left_out = found.by_name_only || (found.fills_box && has_open_faces(scene));
    if (!scene.series.quantities.empty() || !left_out)
      measured.push_back(found);
  }
  return measured;
}

void check_series(Scene const& scene) {
  for (auto const& measured : measured_in_series(scene))
    require(!measured.fills_box || !has_open_faces(scene), "series.quantities", measured.name,
            "is of a fluid that fills its box: not with open faces");
}

MeasuredSeries::MeasuredSeries(Store& store, Scene const& scene, OutputUnits const& units)
    : store_(store), measured_(measured_in_series(scene)), units_(units),
      last_step_(workflows::last_step(store, series_group + "/step")) {
  std::size_t const rows = last_step_ < 0 ? 0 : store_.rows(series_group + "/step");
  for (auto const& measured : measured_)
    if (auto const dataset = dataset_of(measured, units_);
        rows > 0 && (!store_.contains(dataset) || store_.rows(dataset) != rows))
      throw InputError(fmt::format("cannot go on with '{}': '{}' has not the {} rows of '{}/step': the run "
                                   "has measured other quantities before; ask for those",
                                   store_.file().string(), dataset, rows, series_group));
}

void MeasuredSeries::append(sdpd::Simulation const& simulation, std::int64_t step, double time) {
  if (step <= last_step_)
    return;
  for (auto const& measured : measured_) {
    auto values = simulation.measure(measured);
    check(measured, values, step);
    for (double& value : values)
      value *= units_.of(measured.dimension).first;
    auto const dataset = dataset_of(measured, units_);
    store_.append(dataset, values, row_shape(measured));
    if (last_step_ >= 0)
      continue;
    store_.set_attribute(dataset, "meaning", std::string(measured.meaning));
    if (values.size() > 1)
      store_.set_attribute(dataset, "components", columns_of(measured, units_));
  }
  store_.append(series_group + "/time" + units_.time_key, std::span(&time, 1));
  store_.append(series_group + "/step", std::span(&step, 1));
  last_step_ = step;
  store_.flush();
}

cg::Estimate MeasuredComponent::mean() const {
  return mean_of_series(values);
}

std::vector<MeasuredComponent> measured_components(Store const& store, Scene const& scene,
                                                   OutputUnits const& units) {
  std::vector<MeasuredComponent> all;
  if (!store.contains(series_group + "/step"))
    return all;
  for (auto const& measured : measured_in_series(scene)) {
    auto const count = measured.components.size();
    auto const rows = store.read_doubles(dataset_of(measured, units), {.row_shape = row_shape(measured)});
    for (std::size_t c = 0; c < count; ++c) {
      MeasuredComponent one{.of = measured, .component = c, .values = {}};
      for (std::size_t r = c; r < rows.size(); r += count)
        one.values.push_back(rows[r]);
      all.push_back(std::move(one));
    }
  }
  return all;
}

std::vector<double> measured_times(Store const& store, OutputUnits const& units) {
  return store.read_doubles(series_group + "/time" + units.time_key);
}

} // namespace mesobridge::workflows
