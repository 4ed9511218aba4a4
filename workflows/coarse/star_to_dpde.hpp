#pragma once
#include "md/star_melt.hpp"
#include "workflows/coarse/stages.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// What the way from a melt of stars to a DPDE fluid takes; times in Lennard-Jones units.
struct StarToDpdePlan {
  md::StarMeltSettings melt;       ///< but for the directory
  int configurations = 6;          ///< of held centres
  std::int64_t held_steps = 10000; ///< of each
  double run_time = 1000,
         run_dt = 0.05;         ///< of the coarse fluid, with as many particles as the melt has molecules
  std::optional<double> cutoff; ///< of the potential; if not given, where the melt has no structure left
  std::optional<double> v_P;    ///< of a piston that moves into both fluids; if not given, none does
  int shock_across = 5, shock_along = 60; ///< molecules, and particles, of their boxes
};

/// Of the preset quick (minutes), standard (an hour) or paper.
StarToDpdePlan star_to_dpde_plan(std::string const& preset, std::uint64_t seed);

/// Throws InputError that names what makes no sense.
void check(StarToDpdePlan const& plan);

/// The commands that make the model, in their order; their results lie in folders of `directory`.
std::vector<Stage> model_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory);

/// Those that run it, which come after; `directory` has its scene, scene.toml.
std::vector<Stage> run_stages(std::filesystem::path const& directory);

/// What drives a piston into both fluids, whose T is that of the model; `directory` has the scene of the
/// particles, shock/scene.toml. Needs plan.v_P.
std::vector<Stage> shock_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory, double T);

/// The scene of the coarse fluid at the temperature that the melt has had, which names the model in one line.
std::string coarse_scene(StarToDpdePlan const& plan, double T);

/// That of the coarse fluid before the piston; P is its pressure at rest, from which the run's length is
/// estimated.
std::string shock_scene(StarToDpdePlan const& plan, double T, double P);

} // namespace mesobridge::workflows
