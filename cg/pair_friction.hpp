#pragma once
#include "cg/estimate.hpp"
#include "cg/friction_table.hpp"
#include "cg/held_forces.hpp"
#include <functional>

namespace mesobridge::cg {

/// What is to be found in the forces of held molecules.
struct FrictionSettings {
  double interval = 0; ///< of the frames, > 0
  double bin_width = 0.5;
  double plateau = 0; ///< time at which the integrals end; 0: 8 memory times of the forces
  double cutoff = 0;  ///< of the tables; 0: a bin beyond those whose frictions differ from zero by 2 se
  double knots = 1;   ///< distance of the knots of the tables
};

/// The frictions of pairs in one bin of distance; the integrals over all lags.
struct FrictionBin {
  double r = 0; ///< its middle
  double pairs = 0;
  Estimate par, perp;
  std::vector<Estimate> par_integral, perp_integral;
};

/// The friction of molecules, in the units of the run: cg/README.md, Eqs. (C24) ... (C29).
struct PairFriction {
  Estimate kT;
  Estimate self;           ///< of a molecule, per direction
  Estimate force_variance; ///< of a component of the force on a molecule
  double memory = 0;       ///< integral of the forces' correlation over its first value
  double plateau = 0, time_held = 0;
  std::size_t configurations = 0;
  std::vector<double> lag;
  std::vector<Estimate> correlation;   ///< of a molecule's forces, over its first value
  std::vector<Estimate> self_integral; ///< up to each lag
  std::vector<FrictionBin> bins;       ///< those that hold pairs
  Estimate rise; ///< of the friction of a molecule from the plateau to the last lag: 0 if the plateau is one
  FrictionTable table;
  std::vector<double> par_se, perp_se; ///< standard errors of the table
  Estimate near;        ///< measured sum of (par + 2 perp)/3 over neighbours within the cut-off
  double table_sum = 0; ///< that of the table
};

/// Of 4 or more configurations with the same molecules and numbers of frames; errors are those between the
/// configurations. Throws InputError for others, for settings out of range, frames too far apart to resolve
/// the forces' memory and runs shorter than 20 plateaus, PhysicsError when no friction can be told from
/// noise. `done`: told how many configurations are.
PairFriction pair_friction(std::vector<HeldConfiguration> const& configurations,
                           FrictionSettings const& settings, std::function<void(std::size_t)> const& done);

} // namespace mesobridge::cg
