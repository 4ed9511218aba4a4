#pragma once
#include "workflows/sdpd/particle_frame.hpp"
#include "workflows/store/undo_journal.hpp"
#include <filesystem>
#include <memory>

namespace mesobridge::workflows {

/// A trajectory in the extended XYZ format, text that OVITO and ASE open: for each frame the number of
/// particles, a line with the box, the columns, the step and the time, and one line a particle; lengths in
/// Å, velocities in Å/ps and times in ps, or all in reduced units. Numbers are
/// written so that they read back as the same bits. What was there at the last mark() survives the program's
/// death at any moment. A closed file has a seal beside it (store/seal.hpp), by which damage shows.
class ExtendedXyzWriter {
 public:
  /// Begins a new file. Throws EnvironmentError.
  explicit ExtendedXyzWriter(std::filesystem::path file);

  /// Goes on with a file that an earlier run wrote: from its last mark or, when it was closed, from its end;
  /// what is left of a frame there is cut off (files of versions that did not seal them).
  /// Throws InputError, EnvironmentError when the file is damaged.
  static ExtendedXyzWriter continue_file(std::filesystem::path file);

  /// Throws PhysicsError when a number of the frame is not finite, EnvironmentError when it cannot be
  /// written, InputError when the file holds frames with other columns.
  void append(ParticleFrame const& frame);

  void mark();  ///< the frames so far are safe; throws EnvironmentError
  void close(); ///< the same, for good

  /// Step of the last frame in the file, -1 if there is none.
  std::int64_t last_step() const { return last_step_; }

 private:
  ExtendedXyzWriter(std::filesystem::path file, std::int64_t last_step)
      : file_(std::move(file)), journal_(std::make_unique<UndoJournal>(file_)), last_step_(last_step) {}

  std::filesystem::path file_;
  std::unique_ptr<UndoJournal> journal_; ///< holds no page: frames are only appended
  std::int64_t last_step_ = -1;
  std::string head_there_; ///< of the last frame of an earlier run, until the first one of this
};

} // namespace mesobridge::workflows
