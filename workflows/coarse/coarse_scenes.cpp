#include "workflows/coarse/coarse_scenes.hpp"
#include "fitting/toml_text.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// Particles in a box of that lattice, as scenes begin.
std::string fluid_of_scene(StarToDpdePlan const& plan, double T, std::array<int, 3> const& lattice,
                           std::string const& model) {
  auto const& s = plan.melt;
  return fmt::format(R"(title = "{0} stars at rho = {1}, T = {2:.4g} as DPDE particles"
units = "lj"

[method]
name = "dpde"

[fluid]
rho = {1}
T = {2}

[particles]
N = {3}
model = {4} # mass, S(U), potential, friction and conduction, measured

[box]
lattice = [{5}, {6}, {7}]
)",
                     s.star.name(), s.rho, T, lattice[0] * lattice[1] * lattice[2], fitting::quoted(model),
                     lattice[0], lattice[1], lattice[2]);
}

std::string scheme_of_scene(StarToDpdePlan const& plan, double dt) {
  bool const small = plan.melt.star.atoms() < 12; // whose energies come near the end of S(U) by chance
  return fmt::format(R"(
[scheme]
name = "{}"
conservative = "mclachlan"
dt = "{} tau"
)",
                     small ? "ems" : "ssa", dt);
}

std::string run_of_scene(std::int64_t equilibrate, std::int64_t steps, std::int64_t every,
                         std::uint64_t seed) {
  return fmt::format(R"(
[run]
equilibrate = {}
steps = {}
sample_every = {}
seed = {}
)",
                     equilibrate, steps, every, seed);
}

} // namespace

double settling_time(StarToDpdePlan const& plan) {
  return 20 * std::cbrt(plan.melt.star.atoms() / plan.melt.rho);
}

std::string coarse_scene(StarToDpdePlan const& plan, CoarseRun const& run, double T) {
  auto const& s = plan.melt;
  int const side = int(std::llround(std::cbrt(double(s.molecules))));
  auto const own = "model/" + s.star.name() + "-melt.toml";
  auto const every =
      std::max<std::int64_t>(1, std::llround(s.dt * double(s.sample_every) / run.dt)); // the melt's
  auto const frames = std::max<std::int64_t>(1, std::llround(plan.run_time / (run.dt * double(every))));
  return fluid_of_scene(plan, T, {side, side, side}, run.model.empty() ? own : run.model.string()) +
         scheme_of_scene(plan, run.dt) +
         run_of_scene(std::llround(settling_time(plan) / run.dt), every * frames, every, s.seed) +
         fmt::format(R"(trajectory_every = {0}

[series]
every = {0}
quantities = ["internal_energy_spread"]
)",
                     every);
}

std::string shock_scene(StarToDpdePlan const& plan, double T, double P) {
  auto const& s = plan.melt;
  double const spacing = std::cbrt(s.star.atoms() / s.rho), dt = plan.runs.front().dt / 2,
               v_P = plan.v_P.value();
  require(P > 0, "pressure of the particles at rest", P, "must be > 0 for a shock");
  // P goes about as rho^2, and a little longer a run does no harm.
  double const v_S = std::sqrt(2 * P / s.rho) + 0.8 * v_P;
  auto const steps = std::llround(plan.shock_along * spacing / v_S / dt);
  auto const every = std::max<std::int64_t>(1, std::llround(0.2 / dt));
  return fluid_of_scene(plan, T, {plan.shock_across, plan.shock_across, plan.shock_along},
                        "../model/" + s.star.name() + "-melt.toml") +
         fmt::format(R"(z = "walls" # mirrors; the lower one is the piston
piston = {}
)",
                     v_P) +
         scheme_of_scene(plan, dt) +
         run_of_scene(std::llround(settling_time(plan) / dt), steps, every, s.seed) +
         fmt::format(R"(
[profile]
axis = "z"
bins = {0}
every = {1}

[series]
every = {1}
quantities = ["wall_pressure", "wall_work"]
)",
                     plan.shock_along, every);
}

} // namespace mesobridge::workflows
