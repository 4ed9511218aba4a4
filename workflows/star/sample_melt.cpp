#include "workflows/star/sample_melt.hpp"
#include "workflows/h5md.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/star/melt_summary.hpp"
#include "workflows/star/star_sampling.hpp"
#include <optional>

namespace mesobridge::workflows {

namespace {

BlobFileHead head_of(md::StarMeltSettings const& settings, double mass) {
  return {.kind = "melt",
          .name = settings.star.name(),
          .fingerprint = settings.fingerprint(),
          .molecules = settings.molecules,
          .atoms = settings.star.atoms(),
          .mass = mass,
          .rho = settings.rho,
          .T = settings.T,
          .set = {}};
}

/// Rank 0's files: the blobs and the trajectory of their centres. Frames are held back until the stretch of
/// the run that made them is complete.
class MeltFiles {
 public:
  MeltFiles(MeltJob const& job, double mass, Provenance const& provenance)
      : blobs_(job.resume && std::filesystem::exists(job.blobs())
                   ? BlobFile::continue_file(job.blobs(), job.settings.fingerprint())
                   : BlobFile(job.blobs(), head_of(job.settings, mass), provenance)),
        mass_(mass) {
    auto const centres = job.settings.directory / "centres.h5";
    centres_.emplace(job.resume && std::filesystem::exists(centres)
                         ? H5mdWriter::continue_file(centres, H5mdWriter::Units::reduced())
                         : H5mdWriter(centres, H5mdWriter::Units::reduced(), provenance));
    last_centres_ = centres_->last_step();
  }

  void hold(cg::BlobFrame frame) { held_.push_back(std::move(frame)); }

  void write() {
    blobs_.append(held_);
    for (auto const& frame : held_)
      if (frame.step > last_centres_)
        write_centres(frame);
    centres_->mark();
    held_.clear();
  }

  void close() {
    blobs_.close();
    centres_->close();
  }

 private:
  void write_centres(cg::BlobFrame const& frame) {
    std::vector<Vec3> R, V;
    for (auto const& blob : frame.blobs) {
      R.push_back(blob.R);
      V.push_back(blob.P / mass_);
    }
    centres_->append(
        {.step = frame.step, .time = frame.time, .box = frame.box, .positions = R, .velocities = V});
  }

  BlobFile blobs_;
  std::optional<H5mdWriter> centres_;
  std::vector<cg::BlobFrame> held_;
  double mass_;
  std::int64_t last_centres_ = -1;
};

bool run_melt(md::MpiWorld const& world, MeltJob const& job, Context const& context) {
  cg::BlobMaker maker(cg::model_of(job.settings.star));
  std::optional<MeltFiles> files;
  std::optional<Progress> progress;
  if (world.is_root()) {
    files.emplace(
        job, maker.model().mass(),
        Provenance{.command = context.command_line(), .seed = job.settings.seed, .scene = "", .inputs = {}});
    progress.emplace(context.progress(
        fmt::format("melt of {} stars at rho = {}", job.settings.star.name(), job.settings.rho), 1));
  }
  md::StarConsumers const consumers{.frames =
                                        [&](md::MoleculeFrame const& frame) {
                                          auto blobs = cg::gather_blobs(world, frame, maker.blobs(frame));
                                          if (files)
                                            files->hold(std::move(blobs));
                                        },
                                    .checkpoint = [&] { return files ? files->write() : void(); },
                                    .steps = watched(progress)};
  return closed(md::sample_star_melt(world, job.settings, job.resume, consumers), files, progress);
}

} // namespace

void sample_melt(MeltJob const& job, Context const& context) {
  sample_stars(job, context, run_melt,
               [](MeltJob const& done) { return melt_summary(done, read_blobs(done.blobs())); });
}

std::vector<std::string> words_of(MeltJob const& job) {
  auto call = words_of_stars("star-melt", job);
  auto const& s = job.settings;
  call.add("--rho", s.rho);
  call.add("--T", s.T);
  call.add("--friction", s.friction);
  call.add("--squeeze-steps", s.squeeze_steps);
  return call.words;
}

void sample_melt_on_ranks(MeltJob const& job, Context const& context) {
  work_on_ranks(context, words_of(job), [&] { sample_melt(job, context); });
}

} // namespace mesobridge::workflows
