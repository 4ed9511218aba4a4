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
  Store::mend(blobs);
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
  MeltJob job{.settings = melt_settings(plan, star, melt)};
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

cg::Estimate heat_capacity_difference(ChapterMelt const& melt) {
  auto const &C_melt = melt.entropy.curve("melt")->C, &C_vacuum = melt.entropy.curve("vacuum")->C;
  double const ratio = C_melt.mean / C_vacuum.mean;
  return {ratio - 1, ratio * std::hypot(C_melt.se / C_melt.mean, C_vacuum.se / C_vacuum.mean),
          std::min(C_melt.n_eff, C_vacuum.n_eff)};
}

Json chapter_summary(Chapter const& chapter) {
  auto const numbers = [](ChapterMelt const& melt) {
    auto const& c = melt.correlations;
    Json json{{"star", melt.star.name()}, {"rho", melt.rho}};
    put(json, "beta", c.beta);
    put(json, "C_KU", c.C_KU);
    put(json, "C_UD", c.C_UD);
    put(json, "C_UD_configurational", c.configurational.C_UD);
    json["contact_r"] = c.contact;
    put(json, "contact_energy", c.contact_energy);
    put(json, "contact_energy_configurational", c.configurational.contact_energy);
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
