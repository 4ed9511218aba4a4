#include "workflows/store/store_implementation.hpp"
#include <nlohmann/json.hpp>

namespace mesobridge::workflows {

namespace {

using Shape = Expected::Shape;

/// "6 x 27 x 3"
std::string shape_text(Shape const& shape) {
  return shape.empty() ? "a single number" : fmt::format("{}", fmt::join(shape, " x "));
}

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

template <class T>
bool holds(H5T_class_t kind) {
  return kind == H5T_INTEGER || (kind == H5T_FLOAT && std::is_same_v<T, double>);
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

/// Texts go into messages, reports and JSON, which must be UTF-8.
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

/// The bytes of so many values, or the largest number that there is.
std::size_t bytes_of(Shape const& shape, std::size_t of_one) {
  std::size_t bytes = of_one;
  for (auto const extent : shape)
    if (__builtin_mul_overflow(bytes, extent, &bytes) && extent > 0)
      return std::numeric_limits<std::size_t>::max();
  return bytes;
}

/// Reads one dataset or one attribute, and names it in what it refuses.
class Reading {
 public:
  Reading(std::filesystem::path file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

  [[noreturn]] void refuse(std::string const& what) const {
    throw InputError(fmt::format("'{}': {} {}", file_.string(), name_, what));
  }

  /// Refuses what is of another kind, or of another shape than allowed.
  template <class T>
  void check_kind(hid_t type, Shape const& shape, Expected const& expected) const {
    auto const kind = H5Tget_class(type);
    if (!holds<T>(kind))
      refuse(fmt::format("holds {}: must be {}", class_text(kind), wanted<T>()));
    if (!fits(shape, expected))
      refuse(fmt::format("is {}: {}", shape_text(shape), allowed_text(expected)));
  }

  /// Refuses extents that the file cannot hold, however well it is packed.
  void check_size(Hdf5Handle const& dataset, Shape const& shape, std::size_t of_one) const {
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
  void check_values(std::vector<T> const& values, hid_t type, Shape const& shape, Bounds const& bounds,
                    std::size_t first = 0) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (beyond(values[i], type) || !bounds.allows(static_cast<double>(values[i])))
        throw InputError(fmt::format("'{}': {}{} = {}: must be {}", file_.string(), name_,
                                     place_text(first + i, shape), values[i], bounds.text()));
  }

 private:
  std::filesystem::path file_;
  std::string name_;
};

} // namespace

void Store::Implementation::refuse(std::string const& what) const {
  auto const cause = hdf5_system_cause();
  auto const message = fmt::format("{} '{}': {}", what, file.string(), cause.empty() ? hdf5_cause() : cause);
  if (!cause.empty())
    throw EnvironmentError(message);
  throw InputError(message);
}

Hdf5Handle Store::Implementation::opened(Hdf5Handle result, std::string const& what) const {
  if (!result.valid())
    refuse(what);
  return result;
}

Hdf5Handle Store::Implementation::open_dataset(std::string const& path) const {
  if (!contains(path))
    throw InputError(fmt::format("'{}' has no dataset '{}'", file.string(), path));
  Hdf5Handle const object(
      opened({H5Oopen(handle.get(), path.c_str(), H5P_DEFAULT), H5Oclose}, "cannot open '" + path + "' of"));
  if (H5Iget_type(object.get()) != H5I_DATASET)
    throw InputError(fmt::format("'{}': '{}' is no dataset", file.string(), path));
  return opened({H5Dopen2(handle.get(), path.c_str(), H5P_DEFAULT), H5Dclose},
                "cannot open dataset '" + path + "' of");
}

Store::Shape Store::Implementation::shape_of(Hdf5Handle const& dataset) const {
  return shape_of_space({H5Dget_space(dataset.get()), H5Sclose});
}

template <class T>
std::vector<T> Store::Implementation::read(std::string const& path, Expected const& expected,
                                           std::optional<std::size_t> row) const {
  auto const dataset = open_dataset(path);
  Hdf5Handle const type(H5Dget_type(dataset.get()), H5Tclose), space(H5Dget_space(dataset.get()), H5Sclose);
  auto const shape = shape_of_space(space);
  Reading const reading(file, "dataset '" + path + "'");
  reading.check_kind<T>(type.get(), shape, expected);
  reading.check_size(dataset, shape, sizeof(T));
  auto extent = extents(shape);
  std::size_t first = 0;
  if (row) {
    if (shape.empty() || *row >= shape[0])
      reading.refuse(fmt::format("is {}: it has no row {}", shape_text(shape), *row));
    std::vector<hsize_t> start(shape.size(), 0);
    start[0] = *row, extent[0] = 1;
    check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
          "select rows of dataset '" + path + "' of");
    first = *row * product({extent.begin(), extent.end()});
  }
  std::vector<T> values(product({extent.begin(), extent.end()}));
  Hdf5Handle const memory = simple_space({static_cast<hsize_t>(values.size())});
  if (!values.empty() &&
      H5Dread(dataset.get(), memory_type<T>(), memory.get(), space.get(), H5P_DEFAULT, values.data()) < 0)
    refuse("cannot read dataset '" + path + "' of");
  reading.check_values(values, type.get(), shape, expected.bounds, first);
  return values;
}

std::vector<double> Store::read_doubles(std::string const& path, Expected const& expected) const {
  return implementation_->read<double>(path, expected, std::nullopt);
}
std::vector<std::int64_t> Store::read_integers(std::string const& path, Expected const& expected) const {
  return implementation_->read<std::int64_t>(path, expected, std::nullopt);
}
std::vector<double> Store::read_row(std::string const& path, std::size_t row,
                                    Expected const& expected) const {
  return implementation_->read<double>(path, expected, row);
}
std::vector<std::int64_t> Store::read_integer_row(std::string const& path, std::size_t row,
                                                  Expected const& expected) const {
  return implementation_->read<std::int64_t>(path, expected, row);
}

std::string Store::read_text(std::string const& path) const {
  auto const& self = *implementation_;
  auto const dataset = self.open_dataset(path);
  Reading const reading(self.file, "dataset '" + path + "'");
  Hdf5Handle const type(H5Dget_type(dataset.get()), H5Tclose);
  auto const shape = self.shape_of(dataset);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 || bytes_of(shape, 1) != 1)
    reading.refuse("is no text of fixed length");
  auto const size = H5Tget_size(type.get());
  reading.check_size(dataset, {}, size);
  std::string text(size, '\0');
  if (H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    self.refuse("cannot read dataset '" + path + "' of");
  text = text.substr(0, text.find('\0'));
  if (!is_utf8(text))
    reading.refuse("is no text in UTF-8");
  return text;
}

Store::Shape Store::shape(std::string const& path) const {
  return implementation_->shape_of(implementation_->open_dataset(path));
}

std::size_t Store::rows(std::string const& path) const {
  auto const found = shape(path);
  if (found.empty())
    throw InputError(
        fmt::format("'{}': dataset '{}' is a single number: must have rows", file().string(), path));
  return found[0];
}

bool Store::contains(std::string const& path) const {
  return implementation_->contains(path);
}

bool Store::is_group(std::string const& path) const {
  auto const& self = *implementation_;
  if (!self.contains(path))
    return false;
  Hdf5Handle const object(H5Oopen(self.handle.get(), path.c_str(), H5P_DEFAULT), H5Oclose);
  return object.valid() && H5Iget_type(object.get()) == H5I_GROUP;
}

std::vector<std::string> Store::list(std::string const& group) const {
  auto const& self = *implementation_;
  if (!is_group(group))
    throw InputError(fmt::format("'{}' has no group '{}'", self.file.string(), group));
  auto const handle = self.opened({H5Gopen2(self.handle.get(), group.c_str(), H5P_DEFAULT), H5Gclose},
                                  "cannot open group '" + group + "' of");
  std::vector<std::string> names;
  auto const collect = [](hid_t, char const* name, H5L_info_t const*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  if (H5Literate(handle.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names) < 0)
    self.refuse("cannot list '" + group + "' of");
  for (auto const& name : names)
    if (!is_utf8(name))
      throw InputError(
          fmt::format("'{}': a name in group '{}' is no text in UTF-8", self.file.string(), group));
  return names;
}

Hdf5Handle Store::Implementation::open_attribute(std::string const& path, std::string const& name) const {
  if (!contains(path) || H5Aexists_by_name(handle.get(), path.c_str(), name.c_str(), H5P_DEFAULT) <= 0)
    throw InputError(fmt::format("'{}' has no attribute '{}' at '{}'", file.string(), name, path));
  return opened(
      {H5Aopen_by_name(handle.get(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose},
      "cannot open attribute '" + name + "' of");
}

template <class T>
T Store::Implementation::read_number_attribute(std::string const& path, std::string const& name,
                                               Bounds const& bounds) const {
  auto const attribute = open_attribute(path, name);
  Hdf5Handle const type(H5Aget_type(attribute.get()), H5Tclose);
  Reading const reading(file, fmt::format("attribute '{}' of '{}'", name, path));
  auto const shape = shape_of_space({H5Aget_space(attribute.get()), H5Sclose});
  if (!holds<T>(H5Tget_class(type.get())))
    reading.refuse(fmt::format("holds {}: must be {}", class_text(H5Tget_class(type.get())),
                               std::is_same_v<T, double> ? "one number" : "one integer"));
  if (bytes_of(shape, 1) != 1)
    reading.refuse(fmt::format("is an array of {}: must be one number", shape_text(shape)));
  std::vector<T> value(1);
  if (H5Aread(attribute.get(), memory_type<T>(), value.data()) < 0)
    refuse("cannot read attribute '" + name + "' of");
  reading.check_values(value, type.get(), {}, bounds);
  return value[0];
}

double Store::read_double_attribute(std::string const& object, std::string const& name,
                                    Bounds const& bounds) const {
  return implementation_->read_number_attribute<double>(object, name, bounds);
}
std::int64_t Store::read_integer_attribute(std::string const& object, std::string const& name,
                                           Bounds const& bounds) const {
  return implementation_->read_number_attribute<std::int64_t>(object, name, bounds);
}

/// Of variable or of fixed length: both are in use.
std::vector<std::string> Store::read_text_attributes(std::string const& object,
                                                     std::string const& name) const {
  auto const& self = *implementation_;
  auto const attribute = self.open_attribute(object, name);
  Hdf5Handle const type(H5Aget_type(attribute.get()), H5Tclose),
      space(H5Aget_space(attribute.get()), H5Sclose);
  Reading const reading(self.file, fmt::format("attribute '{}' of '{}'", name, object));
  if (H5Tget_class(type.get()) != H5T_STRING)
    reading.refuse(fmt::format("holds {}: must be a text", class_text(H5Tget_class(type.get()))));
  auto const what = "cannot read attribute '" + name + "' of";
  auto const count = bytes_of(shape_of_space(space), 1);
  auto const size = H5Tget_size(type.get());
  if (count == 0 || bytes_of({count}, size) > std::filesystem::file_size(file()))
    reading.refuse(count == 0 ? "holds nothing: must be a text" : "is larger than the file: it is damaged");
  std::vector<std::string> texts;
  if (H5Tis_variable_str(type.get()) > 0) {
    std::vector<char*> data(count, nullptr);
    auto memory = attribute_text_type();
    H5Tset_cset(memory.get(), H5Tget_cset(type.get()));
    if (H5Aread(attribute.get(), memory.get(), static_cast<void*>(data.data())) < 0)
      self.refuse(what);
    for (char* const text : data)
      texts.emplace_back(text ? text : "");
    H5Dvlen_reclaim(memory.get(), space.get(), H5P_DEFAULT, static_cast<void*>(data.data()));
  } else {
    std::string all(count * size, '\0');
    if (H5Aread(attribute.get(), type.get(), all.data()) < 0)
      self.refuse(what);
    for (std::size_t k = 0; k < count; ++k) {
      auto const text = all.substr(k * size, size);
      texts.push_back(text.substr(0, text.find('\0')));
    }
  }
  for (auto const& text : texts)
    if (!is_utf8(text))
      reading.refuse("is no text in UTF-8");
  return texts;
}

std::string Store::read_text_attribute(std::string const& object, std::string const& name) const {
  auto const texts = read_text_attributes(object, name);
  if (texts.size() != 1)
    throw InputError(fmt::format("'{}': attribute '{}' of '{}' is an array of {}: must be one text",
                                 file().string(), name, object, texts.size()));
  return texts[0];
}

bool Store::has_attribute(std::string const& object, std::string const& name) const {
  auto const& self = *implementation_;
  return self.contains(object) &&
         H5Aexists_by_name(self.handle.get(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

} // namespace mesobridge::workflows
