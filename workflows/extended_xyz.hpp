#pragma once
#include "workflows/sdpd/particle_frame.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// A trajectory in the extended XYZ format, text that OVITO and ASE open: for each frame the number of
/// particles, a line with the box, the columns, the step and the time, and one line a particle. Numbers are
/// written so that they read back as the same bits.
class ExtendedXyzWriter {
 public:
  /// Begins a new file. Throws EnvironmentError.
  explicit ExtendedXyzWriter(std::filesystem::path file);

  /// Goes on with a file that an earlier run wrote; what a stopped run left of a frame at its end is cut off.
  /// Throws InputError, EnvironmentError.
  static ExtendedXyzWriter continue_file(std::filesystem::path file);

  /// Throws PhysicsError when a number of the frame is not finite, EnvironmentError when it cannot be
  /// written.
  void append(ParticleFrame const& frame);

  /// Step of the last frame in the file, -1 if there is none.
  std::int64_t last_step() const { return last_step_; }

 private:
  ExtendedXyzWriter(std::filesystem::path file, std::int64_t last_step)
      : file_(std::move(file)), last_step_(last_step) {}

  std::filesystem::path file_;
  std::int64_t last_step_ = -1;
};

} // namespace mesobridge::workflows
