#pragma once
#include "workflows/store/hdf5_handle.hpp"
#include "workflows/store/undo_journal.hpp"
#include <optional>

namespace mesobridge::workflows {

/// A file access property list with which HDF5 tells the journal, when there is one, of all that it is about
/// to overwrite. The journal must outlive every file that is opened so.
Hdf5Handle journaled_access(std::optional<UndoJournal>& journal);

} // namespace mesobridge::workflows
