#include "workflows/star/sample_melt.hpp"
#include "workflows/star/melt_files.hpp"
#include "workflows/star/melt_summary.hpp"
#include "workflows/star/star_sampling.hpp"
#include <optional>

namespace mesobridge::workflows {

namespace {

bool run_melt(md::MpiWorld const& world, MeltJob const& job, Context const& context) {
  cg::BlobMaker maker(cg::model_of(job.settings.star));
  std::optional<MeltFiles> files;
  std::optional<Progress> progress;
  if (world.is_root()) {
    files.emplace(
        job.settings.directory, job.resume,
        stars_head("melt", job.settings, maker.model().mass(), job.settings.rho, job.settings.T),
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
  return words_of_melt("star-melt", job).words;
}

void sample_melt_on_ranks(MeltJob const& job, Context const& context) {
  work_on_ranks(context, words_of(job), [&] { sample_melt(job, context); });
}

} // namespace mesobridge::workflows
