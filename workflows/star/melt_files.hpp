#pragma once
#include "cg/blobs.hpp"
#include "workflows/h5md.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/trajectory/unit_style.hpp"
#include <optional>

namespace mesobridge::workflows {

/// Rank 0's files of a melt: the blobs and the trajectory of their centres, in a folder as blobs.h5 and
/// centres.h5. Frames are held back until the stretch of the run that made them is complete.
class MeltFiles {
 public:
  /// With `resume` files that are there are continued; throws InputError when their fingerprint is another.
  MeltFiles(std::filesystem::path const& folder, bool resume, BlobFileHead const& head,
            Provenance const& provenance);

  void hold(cg::BlobFrame frame) { held_.push_back(std::move(frame)); }
  void write();
  void close();

 private:
  void write_centres(cg::BlobFrame const& frame);

  BlobFile blobs_;
  std::optional<H5mdWriter> centres_;
  std::vector<cg::BlobFrame> held_;
  double mass_;
  std::int64_t last_centres_ = -1;
};

} // namespace mesobridge::workflows
