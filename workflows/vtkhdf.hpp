#pragma once
#include "workflows/provenance.hpp"
#include "workflows/sdpd/particle_frame.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// A trajectory in the VTKHDF 2.0 format (docs.vtk.org, "VTKHDF format specification"), which ParaView opens
/// with its time slider: an unstructured grid of vertices whose points move, with the velocities, ids and
/// scalars as point data. Each frame is flushed; what was there at the last mark() survives the program's
/// death at any moment. The steps stand under `mesobridge/step`, outside the format.
class VtkHdfWriter {
 public:
  /// Creates the file. Throws EnvironmentError.
  VtkHdfWriter(std::filesystem::path const& file, Provenance const& provenance);

  /// Opens a file that an earlier run wrote, to append to it. Throws InputError, EnvironmentError.
  static VtkHdfWriter continue_file(std::filesystem::path const& file);

  /// Throws PhysicsError when a number of the frame is not finite; nothing of it is written then.
  void append(ParticleFrame const& frame);

  /// Step of the last frame in the file, -1 if there is none.
  std::int64_t last_step() const;

  void mark() { store_.mark(); } ///< the frames so far are safe
  void close() { store_.close(); }

 private:
  explicit VtkHdfWriter(Store store) : store_(std::move(store)) {}
  void write_vertices(std::size_t count);
  void append_points(std::string const& name, std::vector<Vec3> const& values);
  void append_step(ParticleFrame const& frame, std::int64_t done);

  Store store_;
};

} // namespace mesobridge::workflows
