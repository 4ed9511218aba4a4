#include "hdf5_numbers.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <hdf5.h>

namespace mesobridge::tests {
namespace {

struct Collector {
  std::vector<std::pair<std::string, std::vector<double>>> all;
};

herr_t collect(hid_t group, char const* name, H5O_info_t const* info, void* data) {
  if (info->type != H5O_TYPE_DATASET)
    return 0;
  hid_t const dataset = H5Dopen2(group, name, H5P_DEFAULT), type = H5Dget_type(dataset),
              space = H5Dget_space(dataset);
  auto const kind = H5Tget_class(type);
  if (kind == H5T_FLOAT || kind == H5T_INTEGER) {
    std::vector<double> values(
        static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)));
    if (values.empty() ||
        H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0)
      static_cast<Collector*>(data)->all.emplace_back(name, std::move(values));
  }
  H5Sclose(space), H5Tclose(type), H5Dclose(dataset);
  return 0;
}

} // namespace

std::vector<std::pair<std::string, std::vector<double>>> numbers_of(std::filesystem::path const& file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  hid_t const handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (handle < 0)
    return {};
  Collector collector;
  H5Ovisit(handle, H5_INDEX_NAME, H5_ITER_INC, collect, &collector);
  H5Fclose(handle);
  return std::move(collector.all);
}

std::string not_finite_in(std::filesystem::path const& folder) {
  for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
    auto const extension = entry.path().extension();
    if (!entry.is_regular_file() || (extension != ".h5" && extension != ".vtkhdf"))
      continue;
    for (auto const& [name, values] : numbers_of(entry.path()))
      for (double const value : values)
        if (!std::isfinite(value))
          return fmt::format("{}: {} holds {}", entry.path().string(), name, value);
  }
  return "";
}

} // namespace mesobridge::tests
