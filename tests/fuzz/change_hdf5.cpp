#include "fuzz/change_hdf5.hpp"
#include "fuzz/change_text.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5.h>
#include <limits>

namespace mesobridge::fuzz {
namespace {

using Shape = std::vector<hsize_t>;

struct Object {
  std::string name;
  H5O_type_t type;
};

std::vector<Object> objects_of(hid_t file) {
  std::vector<Object> objects;
  auto const note = [](hid_t, char const* name, H5O_info_t const* info, void* data) -> herr_t {
    if (std::string_view(name) != ".")
      static_cast<std::vector<Object>*>(data)->push_back({name, info->type});
    return 0;
  };
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, note, &objects);
  return objects;
}

/// A dataset's numbers, whatever their type.
struct Values {
  Shape shape;
  std::vector<double> numbers;
  bool integers = false, is_text = false;
};

Values read(hid_t file, std::string const& name) {
  hid_t const dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT), type = H5Dget_type(dataset),
              space = H5Dget_space(dataset);
  Values values;
  values.shape.resize(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  H5Sget_simple_extent_dims(space, values.shape.data(), nullptr);
  values.integers = H5Tget_class(type) == H5T_INTEGER;
  values.is_text = H5Tget_class(type) != H5T_INTEGER && H5Tget_class(type) != H5T_FLOAT;
  if (!values.is_text) {
    values.numbers.resize(
        static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)));
    if (!values.numbers.empty())
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.numbers.data());
  }
  H5Sclose(space), H5Tclose(type), H5Dclose(dataset);
  return values;
}

/// Writes a dataset of that type in place of the old one, with as many numbers as its shape has.
void replace(hid_t file, std::string const& name, hid_t type, Shape const& shape,
             std::vector<double> numbers) {
  std::size_t count = 1;
  for (auto const edge : shape)
    count *= edge;
  numbers.resize(count, 0.5);
  // Links, not attributes: those are lost as they would be for a program that writes datasets anew.
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  hid_t const space = shape.empty() ? H5Screate(H5S_SCALAR)
                                    : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  hid_t const dataset = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (dataset >= 0 && count > 0)
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  if (dataset >= 0)
    H5Dclose(dataset);
  H5Sclose(space);
}

void replace_by_text(hid_t file, std::string const& name, std::string const& text, bool variable) {
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  hid_t const type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
  H5Tset_size(type, variable ? H5T_VARIABLE : std::max<std::size_t>(text.size(), 1));
  hid_t const dataset = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  char const* const pointer = text.c_str();
  H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
           variable ? static_cast<void const*>(&pointer) : pointer);
  H5Dclose(dataset), H5Sclose(space), H5Tclose(type);
}

double odd_value(Random& random) {
  static std::vector<double> const odd{std::numeric_limits<double>::quiet_NaN(),
                                       std::numeric_limits<double>::infinity(),
                                       -1,
                                       0,
                                       1,
                                       2,
                                       1e300,
                                       -1e300,
                                       1e-300,
                                       9.3e18,
                                       -9.3e18,
                                       4294967296.0,
                                       0.5,
                                       1e6};
  return random.of(odd);
}

std::string change_values(Random& random, hid_t file, std::string const& name, Values values) {
  if (values.numbers.empty())
    return "nothing";
  std::string done;
  switch (random.below(4)) {
  case 0: {
    std::size_t const at = random.below(values.numbers.size());
    values.numbers[at] = odd_value(random);
    done = fmt::format("element {} = {}", at, values.numbers[at]);
    break;
  }
  case 1:
    std::ranges::fill(values.numbers, odd_value(random)), done = fmt::format("all = {}", values.numbers[0]);
    break;
  case 2:
    for (auto& value : values.numbers)
      value *= 1e6;
    done = "times 1e6";
    break;
  default:
    std::ranges::reverse(values.numbers), done = "reversed";
    break;
  }
  replace(file, name, values.integers ? H5T_STD_I64LE : H5T_IEEE_F64LE, values.shape, values.numbers);
  return done;
}

std::string change_shape(Random& random, hid_t file, std::string const& name, Values const& values) {
  Shape shape = values.shape;
  switch (random.below(6)) {
  case 0:
    shape.clear();
    break; // a number
  case 1:
    shape.push_back(random.below(4));
    break; // one dimension more
  case 2:
    shape.assign(1, values.numbers.size());
    break; // flat
  case 3:
    std::ranges::reverse(shape);
    break; // Fortran's order
  default:
    if (!shape.empty()) {
      auto& edge = shape[random.below(shape.size())];
      edge = random.chance(0.3)   ? 0
             : random.chance(0.5) ? edge + 1 + random.below(3)
                                  : edge - std::min<hsize_t>(edge, 1 + random.below(2));
    }
  }
  replace(file, name, values.integers ? H5T_STD_I64LE : H5T_IEEE_F64LE, shape, values.numbers);
  return fmt::format("shape {} -> {}", values.shape, shape);
}

std::string change_type(Random& random, hid_t file, std::string const& name, Values const& values) {
  static std::vector<std::pair<char const*, hid_t>> const types{{"float32", H5T_IEEE_F32BE},
                                                                {"int32", H5T_STD_I32LE},
                                                                {"uint8", H5T_STD_U8LE},
                                                                {"int64", H5T_STD_I64BE},
                                                                {"uint64", H5T_STD_U64LE}};
  switch (random.below(4)) {
  case 0:
    replace_by_text(file, name, "1.5", false);
    return "a text";
  case 1:
    replace_by_text(file, name, "a longer text", true);
    return "a text of variable length";
  default: {
    auto const& [word, type] = random.of(types);
    replace(file, name, type, values.shape, values.numbers);
    return word;
  }
  }
}

std::string change_links(Random& random, hid_t file, std::string const& name,
                         std::vector<Object> const& all) {
  std::string const other = random.of(all).name;
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  switch (random.below(4)) {
  case 0:
    return "removed";
  case 1:
    H5Lcreate_soft(("/" + name).c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    return "a link to itself";
  case 2:
    H5Lcreate_hard(file, other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    return "a link to " + other;
  default:
    H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    return "a group";
  }
}

std::string change_dataset(Random& random, hid_t file, std::string const& name,
                           std::vector<Object> const& all) {
  auto const values = read(file, name);
  switch (random.below(8)) {
  case 0:
    return change_links(random, file, name, all);
  case 1:
    return change_type(random, file, name, values);
  case 2:
  case 3:
  case 4:
    return values.is_text ? change_links(random, file, name, all) : change_shape(random, file, name, values);
  default:
    return values.is_text ? change_type(random, file, name, values)
                          : change_values(random, file, name, values);
  }
}

/// One attribute of an object: removed, or another type, shape or value in its place.
std::string change_attribute(Random& random, hid_t file, std::string const& object) {
  hid_t const owner = H5Oopen(file, object.c_str(), H5P_DEFAULT);
  int const count = H5Aget_num_attrs(owner);
  if (count <= 0) {
    H5Oclose(owner);
    return "nothing";
  }
  hid_t const old = H5Aopen_by_idx(owner, ".", H5_INDEX_NAME, H5_ITER_INC,
                                   random.below(static_cast<std::size_t>(count)), H5P_DEFAULT, H5P_DEFAULT);
  std::string name(256, '\0');
  name.resize(static_cast<std::size_t>(std::max<ssize_t>(H5Aget_name(old, name.size(), name.data()), 0)));
  H5Aclose(old);
  H5Adelete(owner, name.c_str());
  std::string done = "removed";
  if (random.chance(0.75)) {
    std::vector<double> values(1 + random.below(40), odd_value(random));
    hsize_t const length = values.size();
    bool const scalar = random.chance(0.4), integers = random.chance(0.5), empty = random.chance(0.1);
    hid_t const space = empty    ? H5Screate(H5S_NULL)
                        : scalar ? H5Screate(H5S_SCALAR)
                                 : H5Screate_simple(1, &length, nullptr);
    hid_t const type = integers ? H5T_STD_I64LE : H5T_IEEE_F64LE;
    hid_t const fresh = H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
    if (!empty)
      H5Awrite(fresh, H5T_NATIVE_DOUBLE, values.data());
    H5Aclose(fresh), H5Sclose(space);
    done = fmt::format("{} of {} {}",
                       empty    ? "nothing"
                       : scalar ? "one"
                                : "array",
                       integers ? "integers" : "numbers", values[0]);
  }
  H5Oclose(owner);
  return fmt::format("attribute {}: {}", name, done);
}

} // namespace

std::string change_hdf5(Random& random, std::filesystem::path const& path) {
  if (random.chance(0.1))
    return change_bytes(random, path);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  hid_t const file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  if (file < 0)
    return change_bytes(random, path);
  auto const all = objects_of(file);
  if (all.empty()) { // earlier changes took everything away
    H5Fclose(file);
    return change_bytes(random, path);
  }
  auto const& [name, type] = random.of(all);
  std::string const done = type == H5O_TYPE_DATASET && random.chance(0.8)
                               ? change_dataset(random, file, name, all)
                           : random.chance(0.8) ? change_attribute(random, file, name)
                                                : change_links(random, file, name, all);
  H5Fclose(file);
  return fmt::format("{}: {}: {}", path.filename().string(), name, done);
}

} // namespace mesobridge::fuzz
