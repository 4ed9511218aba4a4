#pragma once
#include "md/error.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// The last number of a series of steps in a file, -1 when there is none.
inline std::int64_t last_step(Store const& store, std::string const& dataset) {
  if (!store.contains(dataset))
    return -1;
  auto const rows = store.rows(dataset);
  return rows > 0 ? store.read_integer_row(dataset, rows - 1, {.row_shape = Store::Shape{}}).at(0) : -1;
}

/// A file whose last step is older than the checkpoint lets it have would be left with a gap: it is from an
/// older copy of the run. Throws InputError.
inline void refuse_gap(std::filesystem::path const& file, std::string const& series, std::int64_t last,
                       std::int64_t needed) {
  if (last < needed)
    throw InputError(fmt::format("cannot go on with '{}': '{}' ends at step {}, but the checkpoint beside it "
                                 "comes after step {}: the file is older than the checkpoint",
                                 file.string(), series, last, needed));
}

} // namespace mesobridge::workflows
