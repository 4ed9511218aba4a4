#include "workflows/sdpd/cost_estimate.hpp"
#include "md/error.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "workflows/study/automatic_dt.hpp"
#include "workflows/study/driven_dt.hpp"
#include <array>
#include <numbers>

namespace mesobridge::workflows {
namespace {

constexpr double ns_per_pair = 50; // ideal gas, SSA; the LJ fluid takes a fifth more
// 0.71 kB a particle in all were measured at h_factor 2.5 (64000 and 216000 particles).
constexpr double bytes_per_particle = 330;  // state, forces, working memory
constexpr double candidates_per_pair = 1.5; // the lists reach beyond the range by their skin
constexpr double bytes_per_candidate = 8;   // as a candidate, and as a pair in range
// Inside LAMMPS 1.9 kB in all, on one rank with SSA (10077696 particles): the first rank holds the fluid,
// too.
constexpr double bytes_inside_lammps = 700;
constexpr double bytes_per_pair_inside = 15, bytes_per_momentum = 24; // SER keeps what pairs exchange

double bytes_beside_the_built_in(Scene const& scene, double pairs) {
  double const of_pair = bytes_per_pair_inside + (scene.scheme.name == "ser" ? bytes_per_momentum : 0);
  return static_cast<double>(particles_of(scene)) * bytes_inside_lammps + pairs * of_pair;
}

/// Particles times steps; as a double, since both may be large.
double work_of(Scene const& scene) {
  return static_cast<double>(particles_of(scene)) *
         (static_cast<double>(scene.run.equilibrate) + static_cast<double>(scene.run.steps));
}

double work_of_study(Scene const& scene) {
  if (!scene.scheme.dt.automatic)
    return 0;
  auto const trials = time_step_trials(scene);
  double work = work_of_balance_trials(scene);
  if (!trials.empty())
    work += static_cast<double>(particles_of(trials.front().scene)) * steps_of_start(scene);
  for (auto const& trial : trials)
    work += work_of(trial.scene);
  return work;
}

double work_of_calibration(Scene const& scene) {
  return wants_calibration(scene) ? static_cast<double>(calibration_steps(scene)) *
                                        sdpd::calibrated_particles(calibrated_settings(scene, 1))
                                  : 0;
}

double work_of_viscosity_trials(Scene const& scene) {
  if (!wants_trials_of_viscosity(scene))
    return 0;
  auto settings = settings_of_viscosity_trials(scene, 1);
  if (scene.scheme.dt.automatic)
    settings.dt = largest_tried_dt(scene);
  return sdpd::steps_of_realised_viscosity(settings) * static_cast<double>(settings.particle_count());
}

/// Time of a step inside LAMMPS on one rank over that of the built-in engine's SSA on one thread: 2.2 to 4.1
/// where pairs are stepped in turn, 1.1 to 1.8 where all are at once (sdpd/README.md, On many ranks).
double inside_over_built_in(Scene const& scene) {
  return scene.scheme.name == "ser" ? 1.2 : 3;
}

} // namespace

CostEstimate estimate_cost(Scene const& scene, int threads, Engine engine, int ranks) {
  auto const settings = settings_of(scene, threads);
  double const h = settings.range() / settings.spacing();
  double const neighbours = 4 * std::numbers::pi / 3 * h * h * h;
  double const pairs = static_cast<double>(particles_of(scene)) * neighbours / 2;
  double const seconds_per_work = neighbours / 2 * ns_per_pair * 1e-9 / threads;
  double const run = seconds_per_work * work_of(scene) *
                     (engine == Engine::lammps ? inside_over_built_in(scene) * threads / ranks : 1);
  double const calibration = seconds_per_work * work_of_calibration(scene),
               viscosity = seconds_per_work * work_of_viscosity_trials(scene),
               study = seconds_per_work * work_of_study(scene);
  return {.neighbours = neighbours,
          .seconds = run + calibration + viscosity + study,
          .calibration_seconds = calibration,
          .viscosity_seconds = viscosity,
          .study_seconds = study,
          .bytes = static_cast<double>(particles_of(scene)) * bytes_per_particle +
                   pairs * candidates_per_pair * bytes_per_candidate +
                   (engine == Engine::lammps ? bytes_beside_the_built_in(scene, pairs) : 0)};
}

std::string bytes_text(double bytes) {
  constexpr std::array units{"bytes", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < units.size(); ++unit)
    bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

} // namespace mesobridge::workflows
