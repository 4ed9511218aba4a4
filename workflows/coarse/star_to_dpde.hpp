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
};

/// Of the preset quick (minutes), standard (an hour) or paper.
StarToDpdePlan star_to_dpde_plan(std::string const& preset, std::uint64_t seed);

/// Throws InputError that names what makes no sense.
void check(StarToDpdePlan const& plan);

/// The commands that make the model, in their order; their results lie in folders of `directory`.
std::vector<Stage> model_stages(StarToDpdePlan const& plan, std::filesystem::path const& directory);

/// Those that run it, which come after; `directory` has its scene, scene.toml.
std::vector<Stage> run_stages(std::filesystem::path const& directory);

/// The scene of the coarse fluid at the temperature that the melt has had, which names the model in one line.
std::string coarse_scene(StarToDpdePlan const& plan, double T);

} // namespace mesobridge::workflows
