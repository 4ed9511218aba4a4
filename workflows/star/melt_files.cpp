#include "workflows/star/melt_files.hpp"

namespace mesobridge::workflows {

namespace {

BlobFile blob_file(std::filesystem::path const& file, bool resume, BlobFileHead const& head,
                   Provenance const& provenance) {
  return resume && std::filesystem::exists(file) ? BlobFile::continue_file(file, head.fingerprint)
                                                 : BlobFile(file, head, provenance);
}

H5mdWriter::Units units_of_centres(BlobFileHead const& head) {
  auto const style = unit_style(head.units);
  if (style.reduced())
    return H5mdWriter::Units::reduced();
  auto const si = H5mdWriter::Units::si();
  return {.length = style.length * si.length, .time = style.time * si.time, .physical = true};
}

} // namespace

MeltFiles::MeltFiles(std::filesystem::path const& folder, bool resume, BlobFileHead const& head,
                     Provenance const& provenance)
    : blobs_(blob_file(folder / "blobs.h5", resume, head, provenance)), mass_(head.mass) {
  auto const centres = folder / "centres.h5";
  auto const units = units_of_centres(head);
  centres_.emplace(resume && std::filesystem::exists(centres) ? H5mdWriter::continue_file(centres, units)
                                                              : H5mdWriter(centres, units, provenance));
  last_centres_ = centres_->last_step();
}

void MeltFiles::write() {
  blobs_.append(held_);
  for (auto const& frame : held_)
    if (frame.step > last_centres_)
      write_centres(frame);
  centres_->mark();
  held_.clear();
}

void MeltFiles::close() {
  blobs_.close();
  centres_->close();
}

void MeltFiles::write_centres(cg::BlobFrame const& frame) {
  std::vector<Vec3> R, V;
  for (auto const& blob : frame.blobs) {
    R.push_back(blob.R);
    V.push_back(blob.P / mass_);
  }
  centres_->append(
      {.step = frame.step, .time = frame.time, .box = frame.box, .positions = R, .velocities = V});
}

} // namespace mesobridge::workflows
