#include "workflows/star/chapter.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

/// Whether a summary that lies there is that of this very run.
bool is_done(std::filesystem::path const& summary, std::string const& fingerprint,
             std::optional<std::int64_t> frames) {
  if (!std::filesystem::exists(summary))
    return false;
  auto const json = Json::parse(read_text_file(summary), nullptr, false);
  return !json.is_discarded() && json.value("settings", "") == fingerprint &&
         (!frames || json.value("frames", std::int64_t{-1}) == *frames);
}

std::filesystem::path make_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot create directory '{}': {}", folder.string(), error.message()));
  return folder;
}

MeltJob melt_job(ChapterPlan const& plan, md::StarPolymer const& star, double rho,
                 std::filesystem::path const& directory, Context const& context) {
  MeltJob job{.settings = plan.melt};
  job.settings.star = star;
  job.settings.rho = rho;
  job.settings.directory = make_folder(directory / fmt::format("melt-{}-{}", star.name(), rho));
  if (is_done(job.summary(), job.settings.fingerprint(), md::frames_of(job.settings)))
    return job;
  job.resume = std::filesystem::exists(job.settings.restart_file());
  sample_melt_on_ranks(job, context);
  return job;
}

BlobData vacuum_data(md::StarVacuumSettings settings, std::filesystem::path const& directory,
                     Context const& context) {
  settings.directory = make_folder(directory / ("vacuum-" + settings.star.name()));
  VacuumJob const job{.settings = settings};
  if (!is_done(job.summary(), settings.fingerprint(), {}))
    sample_vacuum_on_ranks(job, context);
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

} // namespace

ChapterPlan chapter_plan(md::Preset preset, std::uint64_t seed) {
  ChapterPlan plan{
      .molecules = {{{.arms = 6, .beads = 3}, {0.3}}},
      .melt = {.molecules = 343, .equilibration_steps = 10000, .sampling_steps = 300000, .seed = seed},
      .vacuum = {.molecules = 600, .equilibration_steps = 5000, .sampling_steps = 60000, .seed = seed},
      .microcanonical_steps = 20000};
  if (preset == md::Preset::quick)
    return plan;
  plan.molecules = {{{.arms = 6, .beads = 3}, {0.3, 0.1, 0.2, 0.4, 0.5}},
                    {{.arms = 6, .beads = 6}, {0.3}},
                    {{.arms = 6, .beads = 12}, {0.3}}};
  plan.melt.molecules = 500;
  plan.melt.equilibration_steps = 30000;
  plan.vacuum.sampling_steps = 200000;
  plan.microcanonical_steps = 100000;
  if (preset == md::Preset::paper) {
    plan.melt.molecules = 1000;
    plan.melt.equilibration_steps = 100000;
    plan.melt.sampling_steps = 5000000;
    plan.melt.sample_every = 500;
    plan.vacuum.sampling_steps = 1000000;
  }
  return plan;
}

Chapter run_chapter(ChapterPlan const& plan, std::filesystem::path const& directory, Context const& context) {
  Chapter chapter;
  for (auto const& [star, densities] : plan.molecules) {
    auto settings = plan.vacuum;
    settings.star = star;
    auto const canonical = vacuum_data(settings, directory, context);
    settings.ensemble = md::VacuumEnsemble::microcanonical;
    settings.levels = energies_of(canonical);
    settings.sampling_steps = plan.microcanonical_steps;
    auto const microcanonical = vacuum_data(settings, directory, context);
    for (double const rho : densities) {
      auto const job = melt_job(plan, star, rho, directory, context);
      auto data = read_blobs(job.blobs());
      EntropyInputs inputs{.melt = data, .vacuum = canonical, .microcanonical = microcanonical, .order = 3};
      double const h = default_h(data.head);
      auto const series = series_of(std::move(data));
      double const half_edge = series.boxes.front().edge.x / 2;
      cg::CorrelationSettings const how{.h = std::min(h, half_edge),
                                        .pair_stride = default_pair_stride(series)};
      chapter.melts.push_back({.star = star,
                               .rho = rho,
                               .correlations = cg::correlations(series, how),
                               .entropy = entropy_routes(inputs),
                               .run = Json::parse(read_text_file(job.summary()))});
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
