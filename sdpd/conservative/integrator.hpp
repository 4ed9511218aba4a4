#pragma once
#include "sdpd/system/sub_step.hpp"

namespace mesobridge::sdpd {

/// A way for positions and momenta to follow the conservative forces. Each is a file of this room, which
/// scheme/list.cpp lists.
struct ConservativeIntegrator {
  std::string name;                         ///< in scenes and options
  std::string summary;                      ///< a few words
  std::vector<SubStep> (*steps)(double dt); ///< of one step; after the last one the forces are up to date

  /// Whether particles move at all.
  bool moves() const { return !steps(1).empty(); }
};

/// What steps are made of, at constant entropies.
namespace parts {

/// p += f dt
SubStep kick(double dt);

/// p += f kick_dt, then q += p/m drift_dt
SubStep kick_and_drift(double kick_dt, double drift_dt);

/// Lists, densities, temperatures, pressures and forces at the new positions.
SubStep forces();

} // namespace parts

} // namespace mesobridge::sdpd
