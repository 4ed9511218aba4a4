#include "workflows/store/damage_guard.hpp"
#include "workflows/store/reading.hpp"

namespace mesobridge::workflows {

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
  DamageGuard const guard(implementation_->file);
  return implementation_->read<double>(path, expected, std::nullopt);
}
std::vector<std::int64_t> Store::read_integers(std::string const& path, Expected const& expected) const {
  DamageGuard const guard(implementation_->file);
  return implementation_->read<std::int64_t>(path, expected, std::nullopt);
}
std::vector<double> Store::read_row(std::string const& path, std::size_t row,
                                    Expected const& expected) const {
  DamageGuard const guard(implementation_->file);
  return implementation_->read<double>(path, expected, row);
}
std::vector<std::int64_t> Store::read_integer_row(std::string const& path, std::size_t row,
                                                  Expected const& expected) const {
  DamageGuard const guard(implementation_->file);
  return implementation_->read<std::int64_t>(path, expected, row);
}

std::string Store::read_text(std::string const& path) const {
  DamageGuard const guard(implementation_->file);
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
  DamageGuard const guard(implementation_->file);
  return implementation_->shape_of(implementation_->open_dataset(path));
}

std::size_t Store::rows(std::string const& path) const {
  DamageGuard const guard(implementation_->file);
  auto const found = shape(path);
  if (found.empty())
    throw InputError(
        fmt::format("'{}': dataset '{}' is a single number: must have rows", file().string(), path));
  return found[0];
}

bool Store::contains(std::string const& path) const {
  DamageGuard const guard(implementation_->file);
  return implementation_->contains(path);
}

bool Store::is_group(std::string const& path) const {
  DamageGuard const guard(implementation_->file);
  auto const& self = *implementation_;
  if (!self.contains(path))
    return false;
  Hdf5Handle const object(H5Oopen(self.handle.get(), path.c_str(), H5P_DEFAULT), H5Oclose);
  return object.valid() && H5Iget_type(object.get()) == H5I_GROUP;
}

std::vector<std::string> Store::list(std::string const& group) const {
  DamageGuard const guard(implementation_->file);
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

} // namespace mesobridge::workflows
