#pragma once
#include "workflows/store/page_digest.hpp"
#include <cstdint>
#include <filesystem>
#include <unordered_set>

namespace mesobridge::workflows {

/// Leads a file that is being written back to the state at which the journal began. Before a part of that
/// state is overwritten or cut off, its pages are appended to FILE.undo beside the file; so a process that
/// dies at any moment leaves all that is needed to undo what it did since. Costs as much as is overwritten,
/// however long the file is: next to nothing for what is only appended.
///
/// It holds against power loss too: the state is on the disk before the journal that leads back to it
/// replaces the older one, and a record is on the disk before its page may change. So that this takes one
/// wait for the disk and not one for each page, a journal begins with the pages that kept changing under the
/// journal before it. And it holds against damage: each record has a checksum, and the head that of the whole
/// file, which must come out before anything is undone.
class UndoJournal {
 public:
  /// Begins with the file as it is now, its first `length` bytes, or all of it; reads them. An older journal
  /// is replaced. Throws EnvironmentError.
  UndoJournal(std::filesystem::path file, std::uint64_t length);
  explicit UndoJournal(std::filesystem::path file);
  UndoJournal(UndoJournal const&) = delete;
  UndoJournal& operator=(UndoJournal const&) = delete;

  /// To be called before `size` bytes at `offset` of the file change. Throws EnvironmentError; the file must
  /// not be written from then on.
  void protect(std::uint64_t offset, std::uint64_t size);
  /// The same before the file is cut down to `length`.
  void protect_beyond(std::uint64_t length);

  /// From here on the state that the file is in now is the one to go back to. Throws EnvironmentError; the
  /// file must not be written from then on.
  void renew();

  static bool exists(std::filesystem::path const& file);
  /// Waits until a writer that has closed the file has taken its journal away, too: it holds the journal's
  /// lock until then. Returns at once when there is no journal, or that of a dead writer.
  static void wait_for_writer(std::filesystem::path const& file);
  /// Returns the file to the state at which its journal began; may itself be broken off and repeated. The
  /// journal stays. Nothing happens without a journal. Throws EnvironmentError, and before it touches the
  /// file when the journal or what it cannot undo is damaged.
  static void roll_back(std::filesystem::path const& file);
  /// From now on there is nothing to undo. Throws EnvironmentError.
  static void discard(std::filesystem::path const& file);

 private:
  /// Writes a journal of the state now that holds these pages, and puts it in place of the older one.
  void begin(std::unordered_set<std::uint64_t> const& pages);
  void save(std::unordered_set<std::uint64_t> const& pages, Descriptor const& journal,
            std::uint64_t first_record) const;

  std::filesystem::path file_;
  Descriptor source_, journal_;             ///< the file, to read, and its journal, to append
  PageDigest digest_;                       ///< of the file at the beginning
  std::unordered_set<std::uint64_t> saved_; ///< pages that the journal holds
  /// Pages that were added to the file, and all that will probably change again: those that were there and
  /// changed, and those that were added and changed since.
  std::unordered_set<std::uint64_t> appended_, changing_;
  bool failed_ = false;
};

} // namespace mesobridge::workflows
