#pragma once
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// The last number of a series of steps in a file, -1 when there is none.
inline std::int64_t last_step(Store const& store, std::string const& dataset) {
  if (!store.contains(dataset))
    return -1;
  auto const rows = store.rows(dataset);
  return rows > 0 ? store.read_integer_row(dataset, rows - 1, {.row_shape = Store::Shape{}}).at(0) : -1;
}

} // namespace mesobridge::workflows
