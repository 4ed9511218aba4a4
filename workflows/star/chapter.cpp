#include "workflows/star/chapter.hpp"
#include "cg/too_short.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {

namespace {

/// The frames that a finished run of these settings has left there; -1 without one.
std::int64_t frames_there(std::filesystem::path const& summary, std::string const& fingerprint) {
  if (!std::filesystem::exists(summary))
    return -1;
  auto const json = Json::parse(read_text_file(summary), nullptr, false);
  bool const same = !json.is_discarded() && json.value("settings", "") == fingerprint;
  return same ? json.value("frames", std::int64_t{-1}) : -1;
}

/// Whether there is a checkpoint to go on from. What other settings have left there is not replaced unasked.
bool to_be_resumed(std::filesystem::path const& blobs, std::filesystem::path const& checkpoint,
                   std::string const& fingerprint) {
  if (!std::filesystem::exists(checkpoint) || !std::filesystem::exists(blobs))
    return false;
  if (auto const was = read_blob_head(blobs).fingerprint; was != fingerprint)
    throw InputError(fmt::format("'{}' is of a run with other settings ({}): remove it or choose another "
                                 "folder with -o",
                                 blobs.string(), was));
  return true;
}

std::filesystem::path make_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot create directory '{}': {}", folder.string(), error.message()));
  return folder;
}

MeltJob melt_run(ChapterPlan const& plan, md::StarPolymer const& star, ChapterPlan::Melt const& melt,
                 std::filesystem::path const& directory, Context const& context) {
  MeltJob job{.settings = plan.melt};
  job.settings.star = star;
  job.settings.rho = melt.rho;
  job.settings.molecules = melt.molecules;
  job.settings.sampling_steps = melt.sampling_steps;
  job.settings.directory = make_folder(directory / fmt::format("melt-{}-{}", star.name(), melt.rho));
  if (frames_there(job.summary(), job.settings.fingerprint()) >= md::frames_of(job.settings))
    return job;
  job.resume = to_be_resumed(job.blobs(), job.settings.restart_file(), job.settings.fingerprint());
  sample_melt_on_ranks(job, context);
  return job;
}

BlobData vacuum_data(md::StarVacuumSettings settings, std::filesystem::path const& directory,
                     Context const& context) {
  settings.directory = make_folder(directory / ("vacuum-" + settings.star.name()));
  VacuumJob job{.settings = settings};
  if (frames_there(job.summary(), settings.fingerprint()) < 0) {
    job.resume = to_be_resumed(job.blobs(), settings.restart_file(), settings.fingerprint());
    sample_vacuum_on_ranks(job, context);
  }
  return read_blobs(job.blobs());
}

/// Energies at which the molecule is run without a thermostat: the means at the temperatures and between
/// them.
std::vector<double> energies_of(BlobData const& canonical) {
  std::map<double, std::pair<double, double>> sums;
  auto const molecules = std::size_t(canonical.head.molecules);
  for (std::size_t k = 0; k < canonical.U_kin.size(); ++k) {
    auto& [sum, count] = sums[canonical.head.set[k % molecules]];
    sum += canonical.U(k), count += 1;
  }
  std::vector<double> energies;
  for (auto const& [T, mean] : sums) {
    double const U = std::round(10 * mean.first / mean.second) / 10;
    if (!energies.empty())
      energies.push_back((energies.back() + U) / 2);
    energies.push_back(U);
  }
  return energies;
}

struct VacuumRuns {
  BlobData canonical, microcanonical;
};

VacuumRuns vacuum_runs(ChapterPlan const& plan, md::StarPolymer const& star,
                       std::filesystem::path const& directory, Context const& context) {
  auto settings = plan.vacuum;
  settings.star = star;
  auto canonical = vacuum_data(settings, directory, context);
  settings.ensemble = md::VacuumEnsemble::microcanonical;
  settings.levels = energies_of(canonical);
  settings.sampling_steps = plan.microcanonical_steps;
  return {std::move(canonical), vacuum_data(settings, directory, context)};
}

/// A length of at least that time and a little more, which ends with a checkpoint.
std::int64_t steps_for(double time, md::StarMeltSettings const& settings) {
  constexpr double margin = 1.2;
  auto const every = double(settings.checkpoint_every);
  return std::int64_t(std::ceil(margin * time / settings.dt / every) * every);
}

ChapterMelt analysed(MeltJob const& job, VacuumRuns const& vacuum) {
  auto data = read_blobs(job.blobs());
  auto entropy = entropy_routes(
      {.melt = data, .vacuum = vacuum.canonical, .microcanonical = vacuum.microcanonical, .order = 3});
  double const h = default_h(data.head);
  auto const series = series_of(std::move(data));
  double const half_edge = series.boxes.front().edge.x / 2;
  cg::CorrelationSettings const how{.h = std::min(h, half_edge), .pair_stride = default_pair_stride(series)};
  return {.star = job.settings.star,
          .rho = job.settings.rho,
          .correlations = cg::correlations(series, how),
          .entropy = std::move(entropy),
          .run = Json::parse(read_text_file(job.summary()))};
}

} // namespace

ChapterPlan chapter_plan(md::Preset preset, std::uint64_t seed) {
  constexpr md::StarPolymer small{.arms = 6, .beads = 3}, middle{.arms = 6, .beads = 6},
      large{.arms = 6, .beads = 12};
  ChapterPlan plan{
      .molecules = {{small, {{.rho = 0.3, .molecules = 343, .sampling_steps = 300000}}}},
      .melt = {.equilibration_steps = 10000, .seed = seed},
      .vacuum = {.molecules = 600, .equilibration_steps = 5000, .sampling_steps = 60000, .seed = seed},
      .microcanonical_steps = 20000};
  if (preset == md::Preset::quick)
    return plan;
  plan.melt.equilibration_steps = 30000;
  plan.melt.sample_every = 200;
  plan.vacuum.sampling_steps = 100000;
  plan.microcanonical_steps = 30000;
  // Twice the thesis's: the energy still keeps to 1e-4 k_B T a bead.
  plan.melt.dt = plan.vacuum.dt = 0.002;
  // The energies of thin melts forget slowly, and those of large molecules: they are followed for longer. The
  // first melt is the one in which pairs in contact are looked at closely.
  plan.molecules = {{small,
                     {{.rho = 0.3, .molecules = 1000, .sampling_steps = 1000000},
                      {.rho = 0.1, .molecules = 343, .sampling_steps = 600000},
                      {.rho = 0.2, .molecules = 500, .sampling_steps = 400000},
                      {.rho = 0.4, .molecules = 500, .sampling_steps = 300000},
                      {.rho = 0.5, .molecules = 500, .sampling_steps = 300000}}},
                    {middle,
                     {{.rho = 0.3, .molecules = 400, .sampling_steps = 300000},
                      {.rho = 0.1, .molecules = 216, .sampling_steps = 1000000},
                      {.rho = 0.2, .molecules = 343, .sampling_steps = 500000},
                      {.rho = 0.4, .molecules = 400, .sampling_steps = 300000},
                      {.rho = 0.5, .molecules = 400, .sampling_steps = 300000}}},
                    {large,
                     {{.rho = 0.3, .molecules = 343, .sampling_steps = 350000},
                      {.rho = 0.1, .molecules = 128, .sampling_steps = 1500000},
                      {.rho = 0.2, .molecules = 216, .sampling_steps = 750000},
                      {.rho = 0.4, .molecules = 450, .sampling_steps = 350000},
                      {.rho = 0.5, .molecules = 560, .sampling_steps = 300000}}}};
  if (preset == md::Preset::paper) {
    plan.melt.dt = plan.vacuum.dt = 0.001;
    plan.melt.equilibration_steps = 100000;
    plan.melt.sample_every = 500;
    plan.vacuum.sampling_steps = 1000000;
    plan.microcanonical_steps = 100000;
    for (auto& molecule : plan.molecules)
      for (auto& melt : molecule.melts)
        melt.molecules = std::max(melt.molecules, 1000), melt.sampling_steps = 5000000;
  }
  return plan;
}

Chapter run_chapter(ChapterPlan const& plan, std::filesystem::path const& directory, Context const& context) {
  for (bool const first : {true, false}) // what tells most is there first, should the run be interrupted
    for (auto const& [star, melts] : plan.molecules) {
      vacuum_runs(plan, star, directory, context);
      for (std::size_t k = first ? 0 : 1; k < (first ? 1 : melts.size()); ++k)
        melt_run(plan, star, melts[k], directory, context);
    }
  Chapter chapter;
  for (auto const& [star, melts] : plan.molecules) {
    auto const vacuum = vacuum_runs(plan, star, directory, context);
    for (auto melt : melts)
      for (bool enough = false; !enough;) {
        auto const job = melt_run(plan, star, melt, directory, context);
        try {
          chapter.melts.push_back(analysed(job, vacuum));
          enough = true;
        } catch (cg::TooShort const& error) { // its memory is longer than was planned for
          melt.sampling_steps = steps_for(error.needed_time, job.settings);
        }
      }
  }
  return chapter;
}

Json chapter_summary(Chapter const& chapter) {
  auto const numbers = [](ChapterMelt const& melt) {
    auto const& c = melt.correlations;
    Json json{{"star", melt.star.name()}, {"rho", melt.rho}};
    put(json, "beta", c.beta);
    put(json, "C_KU", c.C_KU);
    put(json, "C_UD", c.C_UD);
    put(json, "U_mean", c.U_mean);
    auto const entropy = entropy_json(melt.entropy);
    for (auto const& [key, value] : entropy.items())
      if (key.starts_with("heat_capacity"))
        json[key] = value;
    json["tests"] = correlations_json(c)["tests"];
    json["md"] = melt.run;
    return json;
  };
  Json summary = numbers(chapter.melts.front());
  summary["melts"] = Json::array();
  for (auto const& melt : chapter.melts)
    summary["melts"].push_back(numbers(melt));
  return summary;
}

} // namespace mesobridge::workflows
