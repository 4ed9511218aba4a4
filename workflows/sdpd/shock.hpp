#pragma once
#include "fitting/shock_relations.hpp"
#include "sdpd/observe/shock_front.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// What a piston's run shows of its shock, by its profiles along the piston's way; in the scene's units.
struct ShockOfRun {
  sdpd::SteadyShock measured;
  cg::Estimate mass_per_volume; ///< on the plateau, where `measured` has the mean of the particles' densities
  cg::Estimate T_kin;           ///< on the plateau, of the motion about the slices' velocities
  std::optional<fitting::Shock>
      exact;                 ///< by the relations of Rankine and Hugoniot of the scene's equation of state
  std::vector<double> depth; ///< distance from the front of the means over all frames, < 0 behind it
  std::vector<cg::Estimate> rho, P, T, velocity, T_motion;
};

/// What a shock is found in, in any one set of units: frames, and the same frames with the mass per volume
/// and the temperature of the motion.
struct ShockData {
  sdpd::ShockScale scale;
  std::vector<sdpd::ShockFrame> frames, by_motion;
};

/// Without `exact`. Nothing where the shock is not steady for long enough.
std::optional<ShockOfRun> shock_in(ShockData const& data);

/// Of a run; nothing where there is no piston, or no profile of velocity, rho, T_int, T_kin and P along its
/// way.
std::optional<ShockData> shock_data_of(Store const& store, Scene const& scene,
                                       sdpd::SimulationSettings const& settings);

/// With `exact` where there is one. Nothing where there are no data, or no steady shock.
std::optional<ShockOfRun> shock_of(Store const& store, Scene const& scene,
                                   sdpd::SimulationSettings const& settings);

/// v_S and the plateau's rho, P, T with standard errors, and `rankine_hugoniot`.
void put_shock(Json& json, ShockOfRun const& shock, OutputUnits const& units);

/// A table beside Rankine and Hugoniot's, the way of the front, and the profiles in its frame.
Section shock_section(ShockOfRun const& shock, OutputUnits const& units);

} // namespace mesobridge::workflows
