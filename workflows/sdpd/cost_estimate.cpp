#include "workflows/sdpd/cost_estimate.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include <numbers>

namespace mesobridge::workflows {
namespace {

constexpr double ns_per_pair = 50; // ideal gas, SSA; the LJ fluid takes a fifth more
// 0.71 kB a particle in all were measured at h_factor 2.5 (64000 and 216000 particles).
constexpr double bytes_per_particle = 330;  // state, forces, working memory
constexpr double candidates_per_pair = 1.5; // the lists reach beyond the range by their skin
constexpr double calibrated_particles = 1000;
constexpr double bytes_per_candidate = 8; // as a candidate, and as a pair in range

} // namespace

CostEstimate estimate_cost(Scene const& scene, sdpd::SimulationSettings const& settings) {
  double const h = settings.h_factor, neighbours = 4 * std::numbers::pi / 3 * h * h * h;
  auto const particles = static_cast<double>(scene.particles.N);
  double const pairs = particles * neighbours / 2;
  auto const steps = static_cast<double>(scene.run.equilibrate + scene.run.steps);
  double const calibration =
      wants_calibration(scene)
          ? static_cast<double>(scene.particles.calibration_steps) * std::min(particles, calibrated_particles)
          : 0;
  return {.neighbours = neighbours,
          .seconds =
              neighbours / 2 * (particles * steps + calibration) * ns_per_pair * 1e-9 / settings.threads,
          .bytes = particles * bytes_per_particle + pairs * candidates_per_pair * bytes_per_candidate};
}

} // namespace mesobridge::workflows
