#pragma once
#include "md/box.hpp"
#include <cstddef>
#include <vector>

namespace mesobridge::cg {

/// Forces on molecules whose centres of mass were held in one configuration, at equal intervals.
struct HeldConfiguration {
  Box box;
  std::vector<Vec3> R; ///< the centres
  std::vector<Vec3> F; ///< net force on each without what holds it; number frame * molecules + molecule
  double kT = 0;       ///< of the motion about the centres, its mean
};

/// Pairs in bins of their distance, up to half of the box's narrowest width, and what their forces say. Each
/// bin is divided into finer ones, where pairs are counted alone.
struct PairCorrelations {
  static constexpr std::size_t fine = 10; ///< of a bin
  std::size_t bins = 0, lags = 0;
  std::vector<double> along; ///< number bin * lags + lag: sum over the pairs of <F_mu.e F_nu.e>(t)
  std::vector<double> whole; ///< likewise of <F_mu.F_nu>(t)
  std::vector<double> count; ///< of pairs, number bin * fine + part
};

/// The forces of one configuration less their means over time, as Fourier transforms, which all correlations
/// come from. Those are symmetric in time, and freed from the ends of the run: each lag over its own frames.
class ForceSpectra {
 public:
  /// For lags up to `last` frames, less than all.
  ForceSpectra(HeldConfiguration const& configuration, std::size_t last);

  /// <F_x(t) F_x(0)> of a molecule and a component, the mean over all, of each lag.
  std::vector<double> self() const;
  PairCorrelations pairs(double bin_width, std::size_t bins) const;

 private:
  double const* of(std::size_t molecule, int axis) const {
    return numbers_.data() + (3 * molecule + std::size_t(axis)) * padded_;
  }
  /// From a sum of products of transforms to correlations of each lag; spoils the sum.
  void correlate(double* products, double* correlations) const;

  HeldConfiguration const& configuration_;
  std::size_t molecules_, frames_, last_, padded_;
  std::vector<double> numbers_; ///< half-complex, as GSL's
};

} // namespace mesobridge::cg
