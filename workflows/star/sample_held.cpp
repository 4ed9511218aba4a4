#include "workflows/star/sample_held.hpp"
#include "cg/blobs.hpp"
#include "workflows/star/held_file.hpp"
#include "workflows/star/star_sampling.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace mesobridge::workflows {
namespace {

HeldFile open_held(HeldJob const& job, double mass, Context const& context) {
  auto const& s = job.settings;
  if (job.resume && std::filesystem::exists(job.blobs()))
    return HeldFile::continue_file(job.blobs(), s.fingerprint());
  auto const head = stars_head("held", s, mass, s.rho, s.T);
  return {job.blobs(), head, md::frames_of_each(s),
          Provenance{.command = context.command_line(), .seed = s.seed, .scene = "", .inputs = {}}};
}

bool run_held(md::MpiWorld const& world, HeldJob const& job, Context const& context) {
  cg::BlobMaker maker(cg::model_of(job.settings.star));
  std::optional<HeldFile> file;
  std::optional<Progress> progress;
  std::vector<cg::BlobFrame> held; // until the stretch of the run that made them is complete
  if (world.is_root()) {
    file.emplace(open_held(job, maker.model().mass(), context));
    progress.emplace(context.progress(fmt::format("{} stars at rho = {}, held at their centres",
                                                  job.settings.star.name(), job.settings.rho),
                                      1));
  }
  md::StarConsumers const consumers{.frames =
                                        [&](md::MoleculeFrame const& frame) {
                                          auto blobs = cg::gather_blobs(world, frame, maker.blobs(frame));
                                          if (file)
                                            held.push_back(std::move(blobs));
                                        },
                                    .checkpoint =
                                        [&] {
                                          if (!file)
                                            return;
                                          for (auto const& frame : held)
                                            file->append(frame);
                                          file->mark();
                                          held.clear();
                                        },
                                    .steps = watched(progress)};
  return closed(md::sample_held_blobs(world, job.settings, job.resume, consumers), file, progress);
}

/// The largest spread of the energy, per atom, within a configuration.
double energy_spread(HeldData const& data) {
  double worst = 0;
  for (std::size_t first = 0; first < data.energies.size(); first += data.frames_of_each) {
    auto const begin = data.energies.begin() + std::ptrdiff_t(first);
    auto const [low, high] = std::minmax_element(
        begin, begin + std::ptrdiff_t(std::min(data.frames_of_each, data.energies.size() - first)));
    worst = std::max(worst, *high - *low);
  }
  return worst / double(data.molecules() * std::size_t(data.head.atoms));
}

/// The largest relative difference between the molecules' energies together and the system's: they have no
/// others while their centres stand.
double held_energy_sum_error(HeldData const& data) {
  double worst = 0;
  for (std::size_t frame = 0; frame < data.energies.size(); ++frame) {
    double sum = 0;
    for (std::size_t k = frame * data.molecules(); k < (frame + 1) * data.molecules(); ++k)
      sum += data.U_kin[k] + data.U_pot[k] + data.Phi[k];
    worst = std::max(worst, std::abs(sum - data.energies[frame]) / std::abs(data.energies[frame]));
  }
  return worst;
}

Json held_summary(HeldJob const& job) {
  auto const& s = job.settings;
  auto const data = read_held(job.blobs());
  double const freedoms = 3 * double(data.head.atoms - 1) * double(data.U_kin.size());
  return {{"file", job.blobs().string()},
          {"units", "reduced Lennard-Jones"},
          {"star", s.star.name()},
          {"molecules", s.molecules},
          {"rho", s.rho},
          {"box_edge", data.boxes.front().edge.x},
          {"T_thermostat", s.T},
          {"T_kin", 2 * std::accumulate(data.U_kin.begin(), data.U_kin.end(), 0.0) / freedoms},
          {"dt", s.dt},
          {"configurations", data.whole_configurations()},
          {"time_held", double(s.sampling_steps) * s.dt},
          {"time_apart", double(s.free_steps) * s.dt},
          {"frames", data.steps.size()},
          {"energy_spread_per_bead", energy_spread(data)},
          {"blob_energy_sum_relative_error_max", held_energy_sum_error(data)},
          {"seed", s.seed},
          {"settings", s.fingerprint()}};
}

} // namespace

void sample_held(HeldJob const& job, Context const& context) {
  sample_stars(job, context, run_held, held_summary);
}

std::vector<std::string> words_of(HeldJob const& job) {
  auto call = words_of_melt("held-blobs", job);
  call.add("--configurations", job.settings.configurations);
  call.add("--free-steps", job.settings.free_steps);
  return call.words;
}

void sample_held_on_ranks(HeldJob const& job, Context const& context) {
  work_on_ranks(context, words_of(job), [&] { sample_held(job, context); });
}

std::string held_text(Json const& summary) {
  return fmt::format("{} stars, {} molecules at rho = {}: {} configurations held for {:.4g} time units each\n"
                     "energy spread          {:.3g} a bead\nT of the motion inside {:.4g}\n{}",
                     summary["star"].get<std::string>(), summary["molecules"].get<int>(),
                     summary["rho"].get<double>(), summary["configurations"].get<int>(),
                     summary["time_held"].get<double>(), summary["energy_spread_per_bead"].get<double>(),
                     summary["T_kin"].get<double>(), summary["file"].get<std::string>());
}

} // namespace mesobridge::workflows
