#include "workflows/star/chapter.hpp"
#include "cg/too_short.hpp"
#include "workflows/json_file.hpp"
#include "workflows/star/chapter_runs.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace mesobridge::workflows {

namespace {

MeltJob melt_job(ChapterPlan const& plan, md::StarPolymer const& star, ChapterPlan::Melt const& melt,
                 std::filesystem::path const& directory) {
  MeltJob job{.settings = melt_settings(plan, star, melt)};
  job.settings.directory = directory / fmt::format("melt-{}-{}", star.name(), melt.rho);
  return job;
}

/// The isolated molecule at the temperatures of the plan.
VacuumJob canonical_job(ChapterPlan const& plan, md::StarPolymer const& star,
                        std::filesystem::path const& directory) {
  VacuumJob job{.settings = plan.vacuum};
  job.settings.star = star;
  job.settings.directory = directory / ("vacuum-" + star.name());
  return job;
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

/// The isolated molecule at set energies, which its canonical run tells.
VacuumJob microcanonical_job(ChapterPlan const& plan, VacuumJob const& canonical) {
  VacuumJob job = canonical;
  job.settings.ensemble = md::VacuumEnsemble::microcanonical;
  job.settings.levels = energies_of(read_blobs(canonical.blobs()));
  job.settings.sampling_steps = plan.microcanonical_steps;
  return job;
}

/// The runs of one molecule.
struct MoleculeJobs {
  VacuumJob canonical, microcanonical;
  std::vector<MeltJob> melts;
};

/// Makes what is missing of the runs that the plan names.
std::vector<MoleculeJobs> make_runs_of(ChapterPlan const& plan, std::filesystem::path const& directory,
                                       Context const& context) {
  std::vector<VacuumJob> canonical, microcanonical;
  for (auto const& molecule : plan.molecules)
    canonical.push_back(canonical_job(plan, molecule.star, directory));
  make_runs({}, canonical, context);
  std::vector<MoleculeJobs> jobs;
  std::vector<MeltJob> melts;
  for (std::size_t k = 0; k < plan.molecules.size(); ++k) {
    auto const& [star, list] = plan.molecules[k];
    microcanonical.push_back(microcanonical_job(plan, canonical[k]));
    jobs.push_back({canonical[k], microcanonical[k], {}});
    for (auto const& melt : list)
      jobs[k].melts.push_back(melt_job(plan, star, melt, directory));
    melts.insert(melts.end(), jobs[k].melts.begin(), jobs[k].melts.end());
  }
  make_runs(melts, microcanonical, context);
  return jobs;
}

/// A length of at least that time and a little more, which ends with a checkpoint.
std::int64_t steps_for(double time, md::StarMeltSettings const& settings) {
  constexpr double margin = 1.2;
  auto const every = double(settings.checkpoint_every);
  return std::int64_t(std::ceil(margin * time / settings.dt / every) * every);
}

ChapterMelt analysed(MeltJob const& job, BlobData const& canonical, BlobData const& microcanonical) {
  auto data = read_blobs(job.blobs());
  auto entropy =
      entropy_routes({.melt = data, .vacuum = canonical, .microcanonical = microcanonical, .order = 3});
  double const h = default_h(data.head);
  auto const series = series_of(std::move(data));
  double const half_edge = series.boxes.front().edge.x / 2;
  cg::CorrelationSettings const how{.h = std::min(h, half_edge), .pair_stride = default_pair_stride(series)};
  return {.star = job.settings.star,
          .rho = job.settings.rho,
          .correlations = cg::correlations(series, how),
          .entropy = std::move(entropy),
          .run = read_json(job.summary())};
}

/// The melts that are analysed already, by the places of their molecule and of themselves in the plan.
using Analysed = std::map<std::pair<std::size_t, std::size_t>, ChapterMelt>;

/// Analyses the others of a molecule. Those that are too short for standard errors, because their memory is
/// longer than was planned for, become longer in the plan.
void analyse(std::size_t molecule, MoleculeJobs const& jobs, ChapterPlan& plan, Analysed& found) {
  auto const canonical = read_blobs(jobs.canonical.blobs());
  auto const microcanonical = read_blobs(jobs.microcanonical.blobs());
  for (std::size_t m = 0; m < jobs.melts.size(); ++m)
    try {
      if (!found.contains({molecule, m}))
        found.emplace(std::pair(molecule, m), analysed(jobs.melts[m], canonical, microcanonical));
    } catch (cg::TooShort const& error) {
      plan.molecules[molecule].melts[m].sampling_steps = steps_for(error.needed_time, jobs.melts[m].settings);
    }
}

} // namespace

Chapter run_chapter(ChapterPlan plan, std::filesystem::path const& directory, Context const& context) {
  std::size_t melts = 0;
  for (auto const& molecule : plan.molecules)
    melts += molecule.melts.size();
  Analysed found;
  while (found.size() < melts) {
    auto const jobs = make_runs_of(plan, directory, context);
    for (std::size_t k = 0; k < jobs.size(); ++k)
      analyse(k, jobs[k], plan, found);
  }
  Chapter chapter;
  for (auto& [place, melt] : found)
    chapter.melts.push_back(std::move(melt));
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
