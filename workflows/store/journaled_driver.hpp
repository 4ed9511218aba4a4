#pragma once
#include "workflows/store/hdf5_handle.hpp"
#include "workflows/store/undo_journal.hpp"
#include <optional>
#include <string>

namespace mesobridge::workflows {

/// What stands between HDF5 and a file that it writes.
struct WriteGuard {
  std::optional<UndoJournal> journal; ///< told of all that is about to be overwritten
  /// The cause of the first write that failed. From then on none is let through: HDF5 forgets some failures,
  /// and what it wrote after one might destroy what the journal could not save.
  std::string failure;
};

/// A file access property list with which HDF5 writes through a guard, which must outlive every file that is
/// opened so.
Hdf5Handle guarded_access(WriteGuard& guard);

} // namespace mesobridge::workflows
