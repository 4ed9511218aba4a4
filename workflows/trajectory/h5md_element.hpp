#pragma once
#include "workflows/store/store.hpp"
#include <map>
#include <optional>

namespace mesobridge::workflows {

/// "6 x 27 x 3"
std::string extents_text(Store::Shape const& shape);

/// One element of the H5MD format: a dataset (fixed in time), or a group with value, step and perhaps time.
class H5mdElement {
 public:
  H5mdElement(Store const& store, std::string path);

  bool fixed() const { return fixed_; }
  std::string const& path() const { return path_; }
  std::string const& value() const { return value_; }
  std::vector<std::int64_t> const& steps() const { return steps_; }
  bool has(std::int64_t step) const { return fixed_ || rows_.contains(step); }
  std::optional<double> time(std::size_t row) const {
    return times_.empty() ? std::nullopt : std::optional(times_[row]);
  }
  /// The shape of one frame.
  Store::Shape frame_shape() const {
    return fixed_ ? shape_ : Store::Shape(shape_.begin() + 1, shape_.end());
  }

  std::vector<double> numbers(std::int64_t step, Bounds const& bounds = {}) const;
  std::vector<std::int64_t> integers(std::int64_t step, Bounds const& bounds) const;
  std::optional<std::string> unit() const;
  std::optional<std::string> time_unit() const;
  [[noreturn]] void refuse(std::string const& what) const;

 private:
  /// One a row; or, as the format allows, the number of steps between rows, and the first one as `offset`.
  void read_steps();

  void read_times();

  void refuse_other_rows(std::string const& place) const;

  Store const& store_;
  std::string path_, value_;
  bool fixed_ = false;
  Store::Shape shape_;
  std::vector<std::int64_t> steps_;
  std::map<std::int64_t, std::size_t> rows_;
  std::vector<double> times_;
};

} // namespace mesobridge::workflows
