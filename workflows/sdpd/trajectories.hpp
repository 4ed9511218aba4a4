#pragma once
#include "sdpd/simulation.hpp"
#include "workflows/extended_xyz.hpp"
#include "workflows/h5md.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/vtkhdf.hpp"
#include <optional>

namespace mesobridge::workflows {

/// Steps between frames; 0: none.
struct FrameSchedules {
  std::int64_t h5md = 0, vtkhdf = 0, xyz = 0;
};

/// The H5MD file of a run, with the ending by which MDAnalysis knows it, and what it was called once.
inline constexpr char const *h5md_name = "trajectory.h5md", *former_h5md_name = "trajectory.h5";
inline constexpr char const* vtkhdf_name = "trajectory.vtkhdf";

/// The trajectories that a scene asks for, each in its own format and on its own schedule: `trajectory.h5md`
/// (H5MD), `trajectory.vtkhdf` (ParaView 5.12 and later; for 5.11 `trajectory.hdf.series`, once the run ends)
/// and `trajectory.xyz` (OVITO). A resumed run repeats the steps after its checkpoint bit for bit: frames
/// that a file holds already are skipped, and those that a run which was killed wrote after its last mark()
/// are gone.
class Trajectories {
 public:
  /// Creates the files in the folder or, when the run is resumed, goes on with those that it wrote `before`.
  /// A file that it had ceased to write makes room for a new one. Throws InputError, EnvironmentError.
  Trajectories(Scene const& scene, std::filesystem::path const& folder, Provenance const& provenance,
               std::optional<FrameSchedules> const& before);

  /// From this sampled step to that of the next frame of any of them, at most `steps`.
  std::int64_t steps_to_next(std::int64_t done, std::int64_t steps) const;

  /// Writes the frames that are due after `done` sampled steps.
  void record(std::int64_t done, sdpd::Simulation const& simulation, OutputUnits const& units, double dt);

  /// The frames so far are safe, whatever happens to the program. Throws EnvironmentError.
  void mark();
  void close();

 private:
  template <class F>
  void for_each_writer(F const& f); ///< of those that the scene asks for

  std::filesystem::path folder_;
  Scene::Run schedule_;
  bool si_;
  std::optional<H5mdWriter> h5md_;
  std::optional<VtkHdfWriter> vtkhdf_;
  std::optional<ExtendedXyzWriter> xyz_;
};

} // namespace mesobridge::workflows
