#pragma once
#include "cg/estimate.hpp"
#include "md/box.hpp"
#include <vector>

namespace mesobridge::cg {

/// The blobs of a run at equal intervals: number frame * molecules + molecule. Reduced units, k_B = 1.
struct BlobSeries {
  std::size_t molecules = 0;
  int atoms = 0;           ///< of a molecule
  double mass = 0;         ///< of a molecule
  bool free_atoms = false; ///< no constraint holds them: the motion of all tells the temperature
  std::vector<double> times = {};
  std::vector<Box> boxes = {};
  std::vector<Vec3> R = {}, P = {};
  std::vector<double> U = {}, U_kin = {};

  std::size_t frames() const { return times.size(); }
  double interval() const { return (times.back() - times.front()) / double(times.size() - 1); }
  /// Translational energy of a molecule.
  double K(std::size_t k) const { return norm2(P[k]) / (2 * mass); }
};

/// An integrated autocorrelation time int_0^inf rho(t) dt in the time unit of the run.
struct MemoryTime {
  double tau = 0, se = 0;
};

/// The integrated autocorrelation time of a quantity that every molecule has, from the autocovariances of all
/// molecules together; number frame * molecules + molecule. The sum ends at the first lag beyond 6 tau
/// (Madras and Sokal, J. Stat. Phys. 50, 109 (1988)), which cuts about exp(-6) of it off for a single decay.
MemoryTime memory_time(std::span<double const> values, std::size_t molecules, double interval);

/// The frames of each block of a run: `count` blocks, as equal as may be.
std::vector<std::pair<std::size_t, std::size_t>> time_blocks(std::size_t frames, std::size_t count);

} // namespace mesobridge::cg
