#pragma once
#include "md/star_melt.hpp"
#include "workflows/coarse/stages.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// A run of the coarse fluid, with as many particles as the melt has molecules.
struct CoarseRun {
  std::string name = "run"; ///< its folder
  double dt = 0.05;
  std::filesystem::path model = {}; ///< another melt's model; empty: the one that is found here
  double range = 0;                 ///< of that model's pairs

  std::string scene() const { return name == "run" ? "scene.toml" : "scene-" + name + ".toml"; }
};

/// What the way from a melt of stars to a DPDE fluid takes; times in Lennard-Jones units.
struct StarToDpdePlan {
  md::StarMeltSettings melt;       ///< but for the directory
  int configurations = 6;          ///< of held centres
  std::int64_t held_steps = 10000; ///< of each
  double run_time = 1000;          ///< of each run of the coarse fluid
  std::vector<CoarseRun> runs;     ///< the first is of the model that is found here, and decides what is kept
  std::optional<double> cutoff;    ///< of the potential; if not given, where the melt has no structure left
  std::optional<double> v_P;       ///< of a piston that moves into both fluids; if not given, none does
  int shock_across = 5, shock_along = 60; ///< molecules, and particles, of their boxes, at least
};

/// Of the preset quick (minutes), standard (an hour) or paper.
StarToDpdePlan star_to_dpde_plan(std::string const& preset, std::uint64_t seed);

/// Of the coarse fluid.
std::vector<double> usual_time_steps();

/// Runs at the time steps, and at the first of them one of each other model, whose content their names tell.
/// Throws InputError that names a file that is no model of a particle.
std::vector<CoarseRun> coarse_runs(std::vector<double> const& time_steps,
                                   std::vector<std::filesystem::path> const& other_models);

/// So many steps, a multiple of those between frames, as are wanted at another density than the usual 0.3
/// beads per sigma^3: the thinner a melt, the later its velocities change, which is when friction is read,
/// and the later still its molecules forget their energies (21 time units at 0.1, of which S(U) needs 48).
std::int64_t steps_at(double rho, std::int64_t usual, std::int64_t every);

/// Steps between frames, as many as usual or fewer in melts above 0.4, where internal energies pass on fast.
std::int64_t sample_every_at(double rho, std::int64_t usual);

/// Throws InputError that names what makes no sense.
void check(StarToDpdePlan const& plan);

/// The commands that make the model, in their order; their results lie in folders of `directory`.
std::vector<Stage> model_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory);

/// Those that make the runs, two for each, which come after; `directory` has their scenes.
std::vector<Stage> run_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory);

/// The range of a model's potential and friction. Throws InputError that names a file that is no model.
double range_of(std::filesystem::path const& model);

/// The least molecules across a box for pairs of that range, with room for lists of neighbours.
int least_across(StarToDpdePlan const& plan, double range);

/// What drives a piston into both fluids, whose T is that of the model; `directory` has the scene of the
/// particles, shock/scene.toml. Needs plan.v_P.
std::vector<Stage> shock_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory, double T);

} // namespace mesobridge::workflows
