#pragma once
#include "cg/cubic_splines.hpp"
#include <vector>

namespace mesobridge::cg {

/// What a pair force is made of (cg/README.md, Eq. (C46)): cubic B-splines from `first` to the cut-off but
/// for the last, so that all end at zero there; below `first` the force falls in proportion to r.
class PairForceBasis {
 public:
  /// 0 <= first < cutoff; knots are at most about `knots` apart.
  PairForceBasis(double first, double cutoff, double knots);

  std::size_t size() const { return splines_.size() - 1; }
  double first() const { return splines_.first(); }
  double cutoff() const { return splines_.end(); }

  /// All functions at r <= cutoff.
  std::vector<double> forces(double r) const;
  /// Their integrals from r to the cut-off: what they give the potential.
  std::vector<double> potentials(double r) const;

 private:
  CubicSplines splines_;
  double interval_;
};

} // namespace mesobridge::cg
