#pragma once
#include "md/box.hpp"
#include <span>
#include <vector>

namespace mesobridge::sdpd {

/// The radial distribution function g(r) of particles in a periodic box, in bins of equal width from r = 0 to
/// r_max <= half of the narrowest width of the box; averaged over instants.
class RadialDistribution {
 public:
  /// Throws InputError when r_max does not fit into the box.
  RadialDistribution(Box const& box, double r_max, std::size_t bins);

  /// All pairs of one instant; the cost goes as the square of their number.
  void add(std::span<Vec3 const> q);

  double centre(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_; }
  /// One value a bin. Throws InputError when no instant was added.
  std::vector<double> g() const;
  /// Mean number of neighbours nearer than r (a multiple of the bin's width).
  double neighbours_within(double r) const;

 private:
  Box box_;
  double width_;
  std::vector<double> counts_; ///< of pairs
  double particles_ = 0, instants_ = 0;
};

} // namespace mesobridge::sdpd
