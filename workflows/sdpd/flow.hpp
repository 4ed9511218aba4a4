#pragma once
#include "cg/estimate.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/store/store.hpp"
#include <optional>

namespace mesobridge::workflows {

/// What drives a flow that has an exact solution.
enum class FlowKind {
  couette,    ///< a sliding wall
  poiseuille, ///< a body force between walls
  duct,       ///< a body force along a duct, between walls across two axes
  wave        ///< a body force as a cosine in a periodic box
};

/// What a run shows of the steady flow of its fluid, by its profiles across it; in the scene's units.
struct FlowOfRun {
  FlowKind kind;
  cg::Estimate viscosity;
  std::optional<cg::Estimate> slip_length; ///< beyond the walls, where the profile would meet their velocity
  double from = 0;                         ///< time after which the flow is steady
  std::vector<double> position;            ///< of the slices
  std::vector<cg::Estimate> velocity;      ///< along the flow
  std::vector<double> exact;               ///< of a fluid of that viscosity that does not slip
  bool sees_stress =
      true; ///< false: of Couette's flow, without wall_drag in the series, only the slip is known
};

/// Nothing where no slide or body force drives a flow, where both do, where there is no profile of the
/// velocity across it, or where it is too short: fewer than 40 profiles.
std::optional<FlowOfRun> flow_of(Store const& store, Scene const& scene,
                                 sdpd::SimulationSettings const& settings);

/// `viscosity` and `slip_length` with standard errors.
void put_flow(Json& json, FlowOfRun const& flow, OutputUnits const& units);

/// A table of the viscosity beside the one asked for, and the profile beside the exact one.
Section flow_section(FlowOfRun const& flow, RunResult const& run);

} // namespace mesobridge::workflows
