#pragma once
#include "workflows/store/store.hpp"
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// The profiles of one quantity in a run's file, a row an instant; `component` of `components` numbers a
/// slice.
std::vector<std::vector<double>> profile_rows(Store const& store, std::string const& name, std::size_t slices,
                                              std::size_t components = 1, std::size_t component = 0);

} // namespace mesobridge::workflows
