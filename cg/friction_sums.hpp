#pragma once
#include "cg/friction_table.hpp"
#include "cg/held_forces.hpp"
#include "cg/jackknife.hpp"

/// What pair_friction is made of: sums over configurations, and the integrals that follow from them.
namespace mesobridge::cg {

/// Of the correlations of forces, in frames and in the unit of time.
struct ForceLags {
  std::size_t plateau = 0, last = 0; ///< where the integrals end, and the last one shown
  double interval = 0, time_held = 0;
  double memory = 0; ///< integral of the correlation of a molecule's forces over its first value
};

/// Those for a plateau at that time, or at 8 memory times for 0. Throws InputError when frames are too far
/// apart, or runs too short for it.
ForceLags force_lags(std::vector<HeldConfiguration> const& all, double interval, double plateau);

/// The sums of one configuration.
Sums friction_sums(HeldConfiguration const& one, ForceLags const& lags, std::size_t bins, double bin_width);

/// All that follows from the sums of some configurations, but for the tables.
struct FrictionFromSums {
  double kT = 0, variance = 0;                ///< of a component of a molecule's force
  std::vector<double> self;                   ///< integral up to each lag
  std::vector<double> correlation;            ///< of a molecule's forces, over its first value
  std::vector<std::vector<double>> par, perp; ///< of each bin, up to each lag
  MeasuredFriction at_plateau;
};
FrictionFromSums friction_from(Sums const& sums, ForceLags const& lags, std::size_t bins, double bin_width,
                               std::size_t molecules);

} // namespace mesobridge::cg
