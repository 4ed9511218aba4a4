#pragma once
#include "workflows/store/store_implementation.hpp"

namespace mesobridge::workflows {

/// "6 x 27 x 3"
std::string shape_text(Store::Shape const& shape);

/// What a dataset or an attribute holds, in words.
char const* class_text(H5T_class_t kind);

/// Whether numbers of that kind are read as T.
template <class T>
bool holds(H5T_class_t kind) {
  return kind == H5T_INTEGER || (kind == H5T_FLOAT && std::is_same_v<T, double>);
}

/// Texts go into messages, reports and JSON, which must be UTF-8.
bool is_utf8(std::string const& text);

Store::Shape shape_of_space(Hdf5Handle const& space);

/// The bytes of so many values, or the largest number that there is.
std::size_t bytes_of(Store::Shape const& shape, std::size_t of_one);

/// Reads one dataset or one attribute, and names it in what it refuses.
class Reading {
 public:
  Reading(std::filesystem::path file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

  [[noreturn]] void refuse(std::string const& what) const;

  /// Refuses what is of another kind, or of another shape than allowed.
  template <class T>
  void check_kind(hid_t type, Store::Shape const& shape, Expected const& expected) const;

  /// Refuses extents that the file cannot hold, however well it is packed.
  void check_size(Hdf5Handle const& dataset, Store::Shape const& shape, std::size_t of_one) const;

  /// Refuses values out of bounds; `first` is the place of the first of them in the dataset.
  template <class T>
  void check_values(std::vector<T> const& values, hid_t type, Store::Shape const& shape, Bounds const& bounds,
                    std::size_t first = 0) const;

 private:
  std::filesystem::path file_;
  std::string name_;
};

} // namespace mesobridge::workflows
