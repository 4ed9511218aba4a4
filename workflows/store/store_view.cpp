#include "workflows/store/store_implementation.hpp"

namespace mesobridge::workflows {

void Store::write_view(std::string const& path, Store const& source, std::string const& source_path,
                       std::size_t first, std::size_t rows) {
  auto const& self = *implementation_;
  auto const from = source.implementation_->open_dataset(source_path);
  auto const all = extents(source.shape(source_path));
  if (all.empty() || first + rows > all[0])
    throw std::logic_error(
        fmt::format("dataset '{}' has no rows {} ... {}", source_path, first, first + rows));
  auto some = all;
  some[0] = rows;
  auto begin = std::vector<hsize_t>(all.size(), 0);
  begin[0] = first;
  auto const selected = simple_space(all), shown = simple_space(some);
  auto const name = std::filesystem::proximate(source.file(), file().parent_path()).string();
  Hdf5Handle const layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  self.check(H5Sselect_hyperslab(selected.get(), H5S_SELECT_SET, begin.data(), nullptr, some.data(), nullptr),
             "select '" + source_path + "' for");
  self.check(H5Pset_virtual(layout.get(), shown.get(), name.c_str(), source_path.c_str(), selected.get()),
             "show '" + source_path + "' in");
  Hdf5Handle const type(H5Dget_type(from.get()), H5Tclose);
  self.create_dataset(path, type.get(), shown, layout);
}

} // namespace mesobridge::workflows
