#pragma once
#include "md/lj_fluid.hpp"
#include "workflows/scene/scene.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// One SDPD run of the chain.
struct PlannedRun {
  std::string name; ///< of its folder
  Scene scene;
};

/// The SDPD part of the chain: which scenes with how many steps.
struct SdpdPlan {
  std::vector<PlannedRun> fluid;     ///< the Lennard-Jones fluid by the fitted equation of state, by size
  std::vector<PlannedRun> published; ///< one of them by the published equation of state
  std::vector<PlannedRun> ideal;     ///< the ideal gas, whose distributions are known exactly
  std::vector<PlannedRun> drift;     ///< the ideal gas at several sizes and time steps
};

/// The state of the SDPD fluid: argon at 1000 K and 1150 kg/m^3 (thesis, section 5.1.2).
inline constexpr double fluid_T = 1000, fluid_rho = 1150;

SdpdPlan sdpd_plan(md::Preset preset, std::filesystem::path const& model, std::int64_t seed);

} // namespace mesobridge::workflows
