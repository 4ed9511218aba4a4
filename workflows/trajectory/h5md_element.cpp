#include "workflows/trajectory/h5md_element.hpp"
#include "md/error.hpp"

namespace mesobridge::workflows {

using Shape = Store::Shape;

std::string extents_text(Shape const& shape) {
  return fmt::format("{}", fmt::join(shape, " x "));
}

H5mdElement::H5mdElement(Store const& store, std::string path) : store_(store), path_(std::move(path)) {
  fixed_ = !store.is_group(path_);
  value_ = fixed_ ? path_ : path_ + "/value";
  shape_ = store.shape(value_);
  if (fixed_)
    return;
  if (shape_.empty())
    refuse("is a single number: must have one row a frame");
  if (shape_[0] > 0) // refuses more rows than the file can hold, before there is a step for each
    store.read_row(value_, 0, {.bounds = {.finite = false}});
  read_steps();
  for (std::size_t row = 0; row < steps_.size(); ++row)
    rows_.emplace(steps_[row], row); // of rows with the same step the first
  read_times();
}

std::vector<double> H5mdElement::numbers(std::int64_t step, Bounds const& bounds) const {
  return fixed_ ? store_.read_doubles(value_, {.bounds = bounds})
                : store_.read_row(value_, rows_.at(step), {.bounds = bounds});
}

std::vector<std::int64_t> H5mdElement::integers(std::int64_t step, Bounds const& bounds) const {
  return fixed_ ? store_.read_integers(value_, {.bounds = bounds})
                : store_.read_integer_row(value_, rows_.at(step), {.bounds = bounds});
}

std::optional<std::string> H5mdElement::unit() const {
  return store_.has_attribute(value_, "unit") ? std::optional(store_.read_text_attribute(value_, "unit"))
                                              : std::nullopt;
}

std::optional<std::string> H5mdElement::time_unit() const {
  auto const place = path_ + "/time";
  return !times_.empty() && store_.has_attribute(place, "unit")
             ? std::optional(store_.read_text_attribute(place, "unit"))
             : std::nullopt;
}

void H5mdElement::refuse(std::string const& what) const {
  throw InputError(fmt::format("'{}': the element {} {}", store_.file().string(), path_, what));
}

void H5mdElement::read_steps() {
  auto const place = path_ + "/step";
  if (!store_.contains(place))
    refuse("has no step");
  if (store_.shape(place).empty()) {
    auto const every = store_.read_integers(place, {.bounds = {.least = 1}}).at(0);
    auto const first = store_.has_attribute(place, "offset")
                           ? store_.read_integer_attribute(place, "offset", {.least = 0, .most = 1e15})
                           : 0;
    if (double(every) * double(shape_[0]) > 1e15)
      refuse(fmt::format("has a row every {} steps: these are too many", every));
    for (std::size_t row = 0; row < shape_[0]; ++row)
      steps_.push_back(first + std::int64_t(row) * every);
    return;
  }
  refuse_other_rows(place);
  steps_ = store_.read_integers(place, {.rows = shape_[0], .row_shape = Shape{}, .bounds = {.least = 0}});
}

void H5mdElement::read_times() {
  auto const place = path_ + "/time";
  if (!store_.contains(place))
    return;
  if (store_.shape(place).empty()) {
    double const every = store_.read_doubles(place, {.bounds = {.above = 0}}).at(0);
    double const first =
        store_.has_attribute(place, "offset") ? store_.read_double_attribute(place, "offset") : 0;
    for (std::size_t row = 0; row < shape_[0]; ++row)
      times_.push_back(first + double(row) * every);
    return;
  }
  refuse_other_rows(place);
  times_ = store_.read_doubles(place, {.rows = shape_[0], .row_shape = Shape{}});
}

void H5mdElement::refuse_other_rows(std::string const& place) const {
  if (auto const rows = store_.shape(place); rows != Shape{shape_[0]})
    refuse(fmt::format("has a value of {}, but {} is {}: must have one row for each", extents_text(shape_),
                       place, extents_text(rows)));
}

} // namespace mesobridge::workflows
