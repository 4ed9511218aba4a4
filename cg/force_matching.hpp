#pragma once
#include "cg/inverse_boltzmann.hpp"
#include "md/box.hpp"
#include <functional>

namespace mesobridge::cg {

/// Net forces on molecules at their centres; instants follow each other in time.
struct MoleculeForces {
  std::size_t molecules = 0;
  std::vector<Box> boxes;   ///< of each instant
  std::vector<Vec3> R, F;   ///< number instant * molecules + molecule
  bool independent = false; ///< instants share no memory: errors need not look for one

  std::size_t instants() const { return boxes.size(); }
};

struct ForceMatchingSettings {
  double cutoff = 0;  ///< of the force, within half of the box's narrowest width; rounded to whole bins
  double width = 0.2; ///< of the bins, in whose middles the result stands
  double knots = 0.4; ///< most distance of the knots
  double least_g =
      1e-3; ///< below it, and where half of the blocks have no pair, the force is proportional to r
};

/// A pair force by least squares, cg/README.md, Eqs. (C46) ... (C49); errors are jackknife's over blocks of
/// instants.
struct MatchedForce {
  double width = 0, cutoff = 0;
  double first = 0; ///< below it no pairs: f is proportional to r
  std::size_t unknowns = 0, blocks = 0;
  std::vector<double> pairs;        ///< of molecules, in each bin
  std::vector<Estimate> f;          ///< force in the middles of the bins, > 0 where it pushes apart
  std::vector<Estimate> u;          ///< its potential, 0 at the cut-off
  std::vector<Estimate> mean_force; ///< along the line of two, neighbours included; 0 +- 0 without pairs
  Estimate mean_square;             ///< of a component of the force on a molecule
  Estimate explained;               ///< share of it that pairs explain
  /// Standard errors with blocks twice as long, over those given, root mean square over the bins: about 1
  /// where blocks are long enough. 1 for independent instants and fewer than 8 blocks.
  double longer_blocks = 1;

  double r(std::size_t bin) const { return (double(bin) + 0.5) * width; }
  PairPotential potential() const;
};

/// Throws InputError for fewer than 4 instants, forces that are all zero, settings out of range, and knots so
/// close that pairs do not tell all coefficients. `done`: told the share of the instants that were read.
MatchedForce match_forces(MoleculeForces const& forces, ForceMatchingSettings const& settings,
                          std::function<void(double)> const& done = {});

} // namespace mesobridge::cg
