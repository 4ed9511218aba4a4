#include "workflows/sdpd/profile_rows.hpp"

namespace mesobridge::workflows {

std::vector<std::vector<double>> profile_rows(Store const& store, std::string const& name, std::size_t slices,
                                              std::size_t components, std::size_t component) {
  auto const all = store.read_doubles("profile/" + name);
  std::vector<std::vector<double>> rows(all.size() / (slices * components));
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t s = 0; s < slices; ++s)
      rows[k].push_back(all[(k * slices + s) * components + component]);
  return rows;
}

} // namespace mesobridge::workflows
