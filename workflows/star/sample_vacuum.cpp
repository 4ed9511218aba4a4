#include "workflows/star/sample_vacuum.hpp"
#include "cg/blobs.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/star/star_sampling.hpp"
#include <cmath>
#include <optional>

namespace mesobridge::workflows {

namespace {

/// Isolated molecules have no energy with others beyond round-off.
constexpr double most_Phi = 1e-6;

std::string kind_of(md::StarVacuumSettings const& settings) {
  return settings.ensemble == md::VacuumEnsemble::canonical ? "vacuum canonical" : "vacuum microcanonical";
}

BlobFileHead head_of(md::StarVacuumSettings const& settings, double mass) {
  auto head = stars_head(kind_of(settings), settings, mass, 0, 0);
  for (int m = 0; m < settings.molecules; ++m)
    head.set.push_back(settings.level(m));
  return head;
}

void refuse_neighbours(cg::BlobFrame const& frame) {
  for (std::size_t m = 0; m < frame.blobs.size(); ++m)
    if (std::abs(frame.blobs[m].Phi) > most_Phi)
      throw PhysicsError(
          fmt::format("molecule {} has left its cell by step {} and met another (Phi = {:.3g}): "
                      "the temperature or the time step is too high",
                      m, frame.step, frame.blobs[m].Phi));
}

BlobFile open_file(VacuumJob const& job, double mass, Context const& context) {
  if (job.resume && std::filesystem::exists(job.blobs()))
    return BlobFile::continue_file(job.blobs(), job.settings.fingerprint());
  return {
      job.blobs(), head_of(job.settings, mass),
      Provenance{.command = context.command_line(), .seed = job.settings.seed, .scene = "", .inputs = {}}};
}

bool run_vacuum(md::MpiWorld const& world, VacuumJob const& job, Context const& context) {
  cg::BlobMaker maker(cg::model_of(job.settings.star));
  std::optional<BlobFile> file;
  std::optional<Progress> progress;
  std::vector<cg::BlobFrame> held; // until the stretch of the run that made them is complete
  if (world.is_root()) {
    file.emplace(open_file(job, maker.model().mass(), context));
    progress.emplace(context.progress(
        fmt::format("isolated {} stars, {}", job.settings.star.name(), kind_of(job.settings)), 1));
  }
  md::StarConsumers const consumers{.frames =
                                        [&](md::MoleculeFrame const& frame) {
                                          auto blobs = cg::gather_blobs(world, frame, maker.blobs(frame));
                                          if (!file)
                                            return;
                                          refuse_neighbours(blobs);
                                          held.push_back(std::move(blobs));
                                        },
                                    .checkpoint =
                                        [&] {
                                          if (file)
                                            file->append(held);
                                          held.clear();
                                        },
                                    .steps = watched(progress)};
  return closed(md::sample_star_vacuum(world, job.settings, job.resume, consumers), file, progress);
}

Json vacuum_summary(VacuumJob const& job) {
  auto const data = read_blobs(job.blobs());
  Json json{{"file", job.blobs().string()},        {"units", "reduced Lennard-Jones"},
            {"star", job.settings.star.name()},    {"ensemble", kind_of(job.settings)},
            {"molecules", job.settings.molecules}, {"frames", data.frames()},
            {"seed", job.settings.seed},           {"settings", job.settings.fingerprint()}};
  json["levels"] = Json::array();
  for (std::size_t k = 0; k < job.settings.levels.size(); ++k) {
    std::vector<double> U, U_kin; // of each molecule: they are independent
    for (std::size_t m = k; m < std::size_t(data.head.molecules); m += job.settings.levels.size()) {
      double sum = 0, sum_kin = 0;
      for (std::size_t frame = 0; frame < data.frames(); ++frame) {
        std::size_t const at = frame * std::size_t(data.head.molecules) + m;
        sum += data.U(at), sum_kin += data.U_kin[at];
      }
      U.push_back(sum / double(data.frames())), U_kin.push_back(sum_kin / double(data.frames()));
    }
    Json level{{"set", job.settings.levels[k]}};
    if (U.size() >= 16) {
      put(level, "U_mean", cg::estimate_mean(U));
      put(level, "U_kin_mean", cg::estimate_mean(U_kin));
    }
    json["levels"].push_back(std::move(level));
  }
  return json;
}

} // namespace

std::filesystem::path VacuumJob::blobs() const {
  return settings.directory / (settings.stem() + ".h5");
}

std::filesystem::path VacuumJob::summary() const {
  return std::filesystem::path(blobs()).replace_extension(".json");
}

void sample_vacuum(VacuumJob const& job, Context const& context) {
  sample_stars(job, context, run_vacuum, vacuum_summary);
}

std::vector<std::string> words_of(VacuumJob const& job) {
  auto call = words_of_stars("star-vacuum", job);
  auto const& s = job.settings;
  call.add("--redraw-every", s.redraw_every);
  call.words.emplace_back(s.ensemble == md::VacuumEnsemble::canonical ? "--T" : "--U");
  for (double level : s.levels)
    call.words.push_back(fmt::format("{}", level));
  return call.words;
}

void sample_vacuum_on_ranks(VacuumJob const& job, Context const& context) {
  work_on_ranks(context, words_of(job), [&] { sample_vacuum(job, context); });
}

} // namespace mesobridge::workflows
