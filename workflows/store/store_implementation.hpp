#pragma once
#include "md/error.hpp"
#include "workflows/store/hdf5_handle.hpp"
#include "workflows/store/journaled_driver.hpp"
#include "workflows/store/store.hpp"
#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>

namespace mesobridge::workflows {

template <class T>
hid_t memory_type();
template <>
inline hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}

template <>
inline hid_t memory_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

inline std::size_t product(Store::Shape const& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

inline std::vector<hsize_t> extents(Store::Shape const& shape) {
  return {shape.begin(), shape.end()};
}

inline Hdf5Handle simple_space(std::vector<hsize_t> const& extents, hsize_t const* maximum = nullptr) {
  return {H5Screate_simple(static_cast<int>(extents.size()), extents.data(), maximum), H5Sclose};
}

/// Attributes hold texts of variable length, the only ones that h5py, and with it MDAnalysis, gives back as
/// texts.
inline Hdf5Handle attribute_text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

inline Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(),
              std::max<std::size_t>(size, 1)); // HDF5 has no strings of length 0: padding stands in
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

/// Link properties that create the groups on the way to an object.
inline Hdf5Handle creating_groups() {
  Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.get(), 1);
  return links;
}

/// The calls to HDF5 behind a Store, each one checked.
class Store::Implementation {
 public:
  std::filesystem::path file;
  Safety safety = Safety::plain;
  WriteGuard guard; ///< outlives the handle, whose driver writes through it
  Hdf5Handle handle;

  Hdf5Handle access(Mode mode) {
    return mode == Mode::read ? Hdf5Handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose)
                              : check(guarded_access(guard), "open");
  }

  [[noreturn]] void fail(std::string const& what) const {
    throw EnvironmentError(fmt::format("cannot {} '{}': {}", what, file.string(),
                                       guard.failure.empty() ? hdf5_cause() : guard.failure));
  }

  /// Throws when a write failed, even if HDF5 forgot it.
  void check_writes(std::string const& what) const {
    if (!guard.failure.empty())
      fail(what);
  }

  void check(herr_t status, std::string const& what) const {
    if (status < 0)
      fail(what);
  }

  Hdf5Handle check(Hdf5Handle result, std::string const& what) const {
    if (!result.valid())
      fail(what);
    return result;
  }

  void begin_journal();

  bool contains(std::string const& path) const {
    // H5Lexists wants every group on the way to exist.
    for (auto slash = path.find('/', 1); slash != path.npos; slash = path.find('/', slash + 1))
      if (H5Lexists(handle.get(), path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0)
        return false;
    return path == "/" || H5Lexists(handle.get(), path.c_str(), H5P_DEFAULT) > 0;
  }

  /// What the file itself does not give is the fault of the input, unless the machine names a cause.
  [[noreturn]] void refuse(std::string const& what) const;
  Hdf5Handle opened(Hdf5Handle handle, std::string const& what) const;
  Hdf5Handle open_dataset(std::string const& path) const;
  Hdf5Handle open_attribute(std::string const& path, std::string const& name) const;
  Shape shape_of(Hdf5Handle const& dataset) const;
  /// The whole dataset, or one row of it.
  template <class T>
  std::vector<T> read(std::string const& path, Expected const& expected,
                      std::optional<std::size_t> row) const;
  template <class T>
  T read_number_attribute(std::string const& path, std::string const& name, Bounds const& bounds) const;

  Hdf5Handle create_dataset(std::string const& path, hid_t type, Hdf5Handle const& space,
                            Hdf5Handle const& layout = {H5Pcreate(H5P_DATASET_CREATE), H5Pclose}) const {
    if (contains(path))
      check(H5Ldelete(handle.get(), path.c_str(), H5P_DEFAULT), "replace dataset '" + path + "' in");
    auto const links = creating_groups();
    H5Pset_obj_track_times(layout.get(), false); // equal data make equal files
    return check(
        {H5Dcreate2(handle.get(), path.c_str(), type, space.get(), links.get(), layout.get(), H5P_DEFAULT),
         H5Dclose},
        "create dataset '" + path + "' in");
  }

  template <class T>
  void write(std::string const& path, std::span<T const> values, Shape shape) const {
    if (shape.empty())
      shape = {values.size()};
    if (product(shape) != values.size())
      throw std::logic_error(
          fmt::format("dataset '{}': {} values do not fill the shape", path, values.size()));
    auto const dataset = create_dataset(path, memory_type<T>(), simple_space(extents(shape)));
    check(H5Dwrite(dataset.get(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "write dataset '" + path + "' to");
  }

  template <class T>
  Hdf5Handle create_growing(std::string const& path, std::vector<hsize_t> const& row) const {
    auto const row_bytes = std::accumulate(row.begin(), row.end(), hsize_t{sizeof(T)}, std::multiplies<>());
    std::vector<hsize_t> size{0}, maximum{H5S_UNLIMITED}, chunk{chunk_rows(row_bytes)};
    for (auto const n : row)
      size.push_back(n), maximum.push_back(n), chunk.push_back(n);
    Hdf5Handle const layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(layout.get(), static_cast<int>(chunk.size()), chunk.data());
    return create_dataset(path, memory_type<T>(), simple_space(size, maximum.data()), layout);
  }

  template <class T>
  void append(std::string const& path, std::span<T const> values, Shape const& row_shape) const {
    auto const row = extents(row_shape);
    std::size_t const row_size = product(row_shape);
    if (row_size == 0 || values.size() % row_size != 0)
      throw std::logic_error(fmt::format("dataset '{}': {} values are no whole rows", path, values.size()));
    auto const dataset = contains(path) ? open_dataset(path) : create_growing<T>(path, row);
    Hdf5Handle const old_space(H5Dget_space(dataset.get()), H5Sclose);
    std::vector<hsize_t> size(row.size() + 1);
    if (H5Sget_simple_extent_ndims(old_space.get()) != static_cast<int>(size.size()))
      throw std::logic_error(fmt::format("dataset '{}' has rows of another shape", path));
    H5Sget_simple_extent_dims(old_space.get(), size.data(), nullptr);
    if (!std::equal(row.begin(), row.end(), size.begin() + 1))
      throw std::logic_error(fmt::format("dataset '{}' has rows of another shape", path));

    std::vector<hsize_t> start(size.size(), 0), count = size;
    start[0] = size[0];
    count[0] = values.size() / row_size;
    size[0] += count[0];
    auto const what = "append to dataset '" + path + "' of";
    check(H5Dset_extent(dataset.get(), size.data()), what);
    Hdf5Handle const space(H5Dget_space(dataset.get()), H5Sclose);
    check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
          what);
    check(H5Dwrite(dataset.get(), memory_type<T>(), simple_space(count).get(), space.get(), H5P_DEFAULT,
                   values.data()),
          what);
  }

  Hdf5Handle open_or_create_object(std::string const& path) const {
    if (contains(path))
      return check({H5Oopen(handle.get(), path.c_str(), H5P_DEFAULT), H5Oclose}, "open '" + path + "' of");
    auto const links = creating_groups();
    return check({H5Gcreate2(handle.get(), path.c_str(), links.get(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose},
                 "create group '" + path + "' in");
  }

  void set_attribute(std::string const& path, std::string const& name, hid_t type, Hdf5Handle const& space,
                     void const* data) const {
    auto const object = open_or_create_object(path);
    auto const what = "write attribute '" + name + "' of '" + path + "' to";
    if (H5Aexists(object.get(), name.c_str()) > 0)
      check(H5Adelete(object.get(), name.c_str()), what);
    auto const attribute =
        check({H5Acreate2(object.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose},
              what);
    check(H5Awrite(attribute.get(), type, data), what);
  }
};

} // namespace mesobridge::workflows
