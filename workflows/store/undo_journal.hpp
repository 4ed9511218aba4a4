#pragma once
#include <cstdint>
#include <filesystem>
#include <unordered_set>

namespace mesobridge::workflows {

/// Leads a file that is being written back to the state at which the journal began. Before a part of that
/// state is overwritten or cut off, its pages are appended to FILE.undo beside the file; so a process that
/// dies at any moment leaves all that is needed to undo what it did since. Costs as much as is overwritten,
/// however long the file is: nothing for what is only appended. Data are handed to the operating system, not
/// forced onto the disk: they survive the program's death, not that of the machine.
class UndoJournal {
 public:
  /// Begins with the file as it is now, in place of an older journal. Throws EnvironmentError.
  explicit UndoJournal(std::filesystem::path file);
  UndoJournal(UndoJournal const&) = delete;
  UndoJournal& operator=(UndoJournal const&) = delete;
  ~UndoJournal();

  /// To be called before `size` bytes at `offset` of the file change. Throws EnvironmentError.
  void protect(std::uint64_t offset, std::uint64_t size);
  /// The same before the file is cut down to `length`.
  void protect_beyond(std::uint64_t length);

  static bool exists(std::filesystem::path const& file);
  /// Returns the file to the state at which its journal began; may itself be broken off and repeated. Nothing
  /// happens without a journal. Throws EnvironmentError.
  static void roll_back(std::filesystem::path const& file);
  /// From now on there is nothing to undo. Throws EnvironmentError.
  static void discard(std::filesystem::path const& file);

 private:
  std::filesystem::path file_;
  int source_ = -1, journal_ = -1; ///< descriptors of the file, to read, and of its journal, to append
  std::uint64_t length_ = 0;       ///< of the file at the beginning
  std::unordered_set<std::uint64_t> saved_; ///< pages that the journal holds
};

} // namespace mesobridge::workflows
