#include "workflows/store/reading.hpp"
#include <nlohmann/json.hpp>

namespace mesobridge::workflows {

namespace {

using Shape = Store::Shape;

/// "must be rows of 3 numbers, 6 of them"
std::string allowed_text(Expected const& expected) {
  std::string text = "must be ";
  if (!expected.row_shape && !expected.rows && expected.least_rows == 0)
    return text + "numbers";
  text += expected.rows             ? fmt::format("{}", *expected.rows)
          : expected.least_rows > 0 ? fmt::format("at least {}", expected.least_rows)
                                    : "any number";
  text += " x ";
  if (!expected.row_shape)
    return text + "anything";
  return expected.row_shape->empty() ? text.substr(0, text.size() - 3) + " numbers in one row"
                                     : text + shape_text(*expected.row_shape);
}

bool fits(Shape const& shape, Expected const& expected) {
  if (!expected.row_shape && !expected.rows && expected.least_rows == 0)
    return true;
  if (shape.empty() || shape[0] < expected.least_rows || (expected.rows && shape[0] != *expected.rows))
    return false;
  return !expected.row_shape ||
         std::equal(shape.begin() + 1, shape.end(), expected.row_shape->begin(), expected.row_shape->end());
}

/// "[3][0][2]" of the value with a number.
std::string place_text(std::size_t number, Shape const& shape) {
  std::string text;
  for (std::size_t k = shape.size(); k-- > 0; number /= std::max<std::size_t>(shape[k], 1))
    text = fmt::format("[{}]", number % std::max<std::size_t>(shape[k], 1)) + text;
  return text;
}

template <class T>
constexpr char const* wanted() {
  return std::is_same_v<T, double> ? "numbers" : "integers";
}

/// Unsigned integers beyond the signed ones come out of HDF5 as the largest of those.
template <class T>
bool beyond(T value, hid_t type) {
  if constexpr (std::is_same_v<T, std::int64_t>)
    return value == std::numeric_limits<std::int64_t>::max() && H5Tget_sign(type) == H5T_SGN_NONE;
  else
    return false;
}

} // namespace

std::string shape_text(Shape const& shape) {
  return shape.empty() ? "a single number" : fmt::format("{}", fmt::join(shape, " x "));
}

char const* class_text(H5T_class_t kind) {
  switch (kind) {
  case H5T_INTEGER:
    return "integers";
  case H5T_FLOAT:
    return "floating-point numbers";
  case H5T_STRING:
    return "texts";
  case H5T_COMPOUND:
    return "records";
  case H5T_ENUM:
    return "names of a list (or yes and no)";
  default:
    return "neither numbers nor texts";
  }
}

bool is_utf8(std::string const& text) {
  try {
    return !nlohmann::json(text).dump().empty();
  } catch (nlohmann::json::type_error const&) {
    return false;
  }
}

Shape shape_of_space(Hdf5Handle const& space) {
  if (H5Sget_simple_extent_type(space.get()) == H5S_NULL)
    return {0};
  std::vector<hsize_t> size(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.get()))));
  H5Sget_simple_extent_dims(space.get(), size.data(), nullptr);
  return {size.begin(), size.end()};
}

std::size_t bytes_of(Shape const& shape, std::size_t of_one) {
  std::size_t bytes = of_one;
  for (auto const extent : shape)
    if (__builtin_mul_overflow(bytes, extent, &bytes) && extent > 0)
      return std::numeric_limits<std::size_t>::max();
  return bytes;
}

void Reading::refuse(std::string const& what) const {
  throw InputError(fmt::format("'{}': {} {}", file_.string(), name_, what));
}

template <class T>
void Reading::check_kind(hid_t type, Shape const& shape, Expected const& expected) const {
  auto const kind = H5Tget_class(type);
  if (!holds<T>(kind))
    refuse(fmt::format("holds {}: must be {}", class_text(kind), wanted<T>()));
  if (!fits(shape, expected))
    refuse(fmt::format("is {}: {}", shape_text(shape), allowed_text(expected)));
}

void Reading::check_size(Hdf5Handle const& dataset, Shape const& shape, std::size_t of_one) const {
  constexpr std::size_t never_written = std::size_t{16} << 20, // such values take no room in the file
      densest = 1100;                                          // of deflate, 1032
  Hdf5Handle const layout(H5Dget_create_plist(dataset.get()), H5Pclose);
  std::size_t const packing = H5Pget_nfilters(layout.get()) > 0 ? densest : 1;
  auto const file_size = std::filesystem::file_size(file_);
  auto const stored = std::min<std::size_t>(H5Dget_storage_size(dataset.get()), file_size);
  if (bytes_of(shape, of_one) > stored * packing + never_written)
    refuse(fmt::format("claims {} values, but the file has {} bytes: it is damaged", shape_text(shape),
                       file_size));
}

template <class T>
void Reading::check_values(std::vector<T> const& values, hid_t type, Shape const& shape, Bounds const& bounds,
                           std::size_t first) const {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (beyond(values[i], type) || !bounds.allows(static_cast<double>(values[i])))
      throw InputError(fmt::format("'{}': {}{} = {}: must be {}", file_.string(), name_,
                                   place_text(first + i, shape), values[i], bounds.text()));
}

template void Reading::check_kind<double>(hid_t, Shape const&, Expected const&) const;
template void Reading::check_kind<std::int64_t>(hid_t, Shape const&, Expected const&) const;
template void Reading::check_values(std::vector<double> const&, hid_t, Shape const&, Bounds const&,
                                    std::size_t) const;
template void Reading::check_values(std::vector<std::int64_t> const&, hid_t, Shape const&, Bounds const&,
                                    std::size_t) const;

} // namespace mesobridge::workflows
