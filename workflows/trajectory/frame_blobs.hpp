#pragma once
#include "cg/blobs.hpp"
#include "workflows/trajectory/mapping_file.hpp"
#include "workflows/trajectory/trajectory_file.hpp"
#include <memory>

namespace mesobridge::workflows {

/// The molecules of one frame, and what their atoms have together.
struct FoundBlobs {
  std::vector<cg::Blob> blobs;       ///< their net forces are those of the laws
  double kinetic = 0, potential = 0; ///< of all atoms
  double bonds = 0;                  ///< the part of bonds, where the mapping itself says their laws
};

/// Makes blobs of a trajectory's frames (cg/README.md, Eq. (C7)).
class FrameBlobs {
 public:
  virtual ~FrameBlobs() = default;
  virtual cg::MoleculeModel const& model() const = 0;
  /// Whether pairs of atoms have a law, and so molecules forces.
  virtual bool has_pairs() const = 0;
  /// No image of an atom may be nearer than this along an axis that is not periodic.
  virtual double reach() const = 0;
  /// What a frame must hold.
  virtual void expect(TrajectoryReading& reading) const = 0;
  /// In the box of TrajectoryFrame::image_box.
  virtual FoundBlobs of(TrajectoryFrame const& frame, Box const& box) = 0;
};

/// By the laws that the mapping holds, or by LAMMPS where it names LAMMPS's files; `folder` then gets files
/// for a moment.
std::unique_ptr<FrameBlobs> blobs_by(Mapping const& mapping, std::filesystem::path const& folder);

} // namespace mesobridge::workflows
