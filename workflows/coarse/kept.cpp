#include "workflows/coarse/kept.hpp"
#include "workflows/coarse/coarse_scenes.hpp"
#include "workflows/json_file.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/transport/measured_motion.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

constexpr double bin_width = 0.2; // of g(r)

cg::Estimate estimate_in(Json const& json, std::string const& key) {
  return {json.at(key).get<double>(), json.at(key + "_se").get<double>()};
}

std::optional<cg::Estimate> number_of(TransportResult const& of, std::string const& key) {
  auto const found = std::ranges::find(of.numbers, key, [](auto const& number) { return number.first; });
  return found == of.numbers.end() ? std::nullopt : std::optional(found->second);
}

/// Structures at most so many frames apart that neighbouring ones show the same.
cg::BlobSeries thinned(cg::BlobSeries series) {
  constexpr std::size_t most = 1000;
  std::size_t const stride = std::max<std::size_t>(1, series.frames() / most), N = series.molecules;
  cg::BlobSeries few{.molecules = N, .atoms = series.atoms, .mass = series.mass};
  for (std::size_t k = 0; k < series.frames(); k += stride) {
    few.times.push_back(series.times[k]), few.boxes.push_back(series.boxes[k]);
    few.R.insert(few.R.end(), series.R.begin() + std::ptrdiff_t(k * N),
                 series.R.begin() + std::ptrdiff_t((k + 1) * N));
  }
  return few;
}

/// The state of both fluids.
void add_state(KeptRun& kept, double mass, Json const& melt, Json const& exchange, Json const& run) {
  auto const add = [&](char const* key, char const* what, cg::Estimate const& molecules,
                       cg::Estimate const& particles, double share) {
    kept.quantities.push_back({key, what, molecules, particles, share});
  };
  auto const T = estimate_in(melt, "T_kin");
  add("P", "pressure", estimate_in(melt, "P"), estimate_in(run, "P"), 0.02);
  add("T_kin", "temperature of the motion", T, estimate_in(run, "T_kin"), 0.003);
  add("T_int", "temperature of the internal energies", T, estimate_in(run, "T_int"), 0.003);
  add("internal_energy", "mean internal energy", estimate_in(melt, "U_mean"),
      cg::scaled(estimate_in(run, "e"), mass), 0.01);
  auto const variance = estimate_in(exchange, "variance");
  double const spread = std::sqrt(variance.mean);
  add("internal_energy_spread", "its standard deviation", {spread, variance.se / (2 * spread)},
      estimate_in(run, "internal_energy_spread"), 0.01);
}

void add_motion(KeptRun& kept, TransportResult const& of_molecules) {
  struct Of {
    char const *key, *what;
    double share;
  };
  for (auto const& [key, what, share] :
       {Of{"D", "diffusion, by displacements", 0.1}, Of{"D_velocity", "diffusion, by velocities", 0.1},
        Of{"velocity_decay_time", "time in which velocities fall to 1/e", 0.1},
        Of{"eta", "shear viscosity", 0.15}})
    if (auto const molecules = number_of(of_molecules, key), particles = number_of(kept.particles, key);
        molecules && particles)
      kept.quantities.push_back({key, what, *molecules, *particles, share});
}

/// What one run has kept, which took so many seconds with its way to rest.
KeptRun kept_run(CoarseRun const& run, StarToDpdePlan const& plan, std::filesystem::path const& directory,
                 Kept const& of_melt, double seconds, Context const& context) {
  auto const folder = directory / run.name;
  auto const summary = read_json(folder / "summary.json");
  double const sampled = summary.at("dt").get<double>() * summary.at("steps").get<double>(),
               whole = sampled + settling_time(plan);
  KeptRun kept{.run = run,
               .quantities = {},
               .g_particles = radial_estimate(thinned(read_motion(folder, context).series), bin_width),
               .g = {},
               .particles = read_transport(folder),
               .cost = seconds / (plan.melt.molecules * whole),
               .seconds = seconds * sampled / whole};
  kept.g = structure_difference(kept.g_particles, of_melt.g_molecules);
  add_state(kept, plan.melt.star.atoms(), read_json(directory / "melt/summary.json"),
            read_json(directory / "exchange/exchange.json"), summary);
  add_motion(kept, of_melt.molecules);
  return kept;
}

} // namespace

bool KeptQuantity::kept() const {
  double const apart = std::abs(particles.mean - molecules.mean);
  return apart <= share * std::abs(molecules.mean) || apart <= 3 * std::hypot(particles.se, molecules.se);
}

Kept read_kept(StarToDpdePlan const& plan, std::filesystem::path const& directory, Context const& context) {
  try {
    Kept kept;
    kept.molecules = read_transport(directory / "melt");
    kept.g_molecules =
        radial_estimate(thinned(series_of(read_blobs(directory / "melt/blobs.h5"))), bin_width);
    kept.gamma_self = estimate_in(read_json(directory / "friction/friction.json"), "gamma_self");
    auto const seconds = stage_seconds(directory / "stages.json");
    auto const sampled = md::plan(plan.melt).back();
    double const of_melt = seconds.at(line_of(model_stages(plan, directory).front())),
                 steps = double(sampled.first_step + sampled.steps);
    kept.cost_molecules = of_melt / (plan.melt.molecules * plan.melt.dt * steps);
    kept.seconds_molecules = of_melt * double(plan.melt.sampling_steps) / steps;
    auto const stages = run_stages(plan, directory);
    for (std::size_t k = 0; k < plan.runs.size(); ++k)
      kept.runs.push_back(
          kept_run(plan.runs[k], plan, directory, kept, seconds.at(line_of(stages[2 * k])), context));
    return kept;
  } catch (Json::exception const& error) {
    throw InputError(
        fmt::format("'{}' holds results that are not whole: {}", directory.string(), error.what()));
  } catch (std::out_of_range const&) {
    throw InputError(
        fmt::format("'{}' does not say how long its stages took", (directory / "stages.json").string()));
  }
}

} // namespace mesobridge::workflows
