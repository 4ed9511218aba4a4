#pragma once
#include <cstddef>
#include <vector>

namespace mesobridge::cg {

/// Frictions that were measured on pairs: in bins of distance, each divided into finer ones that tell where
/// its pairs stand.
struct MeasuredFriction {
  double width = 0;              ///< of a bin
  std::size_t fine = 0;          ///< parts of a bin
  std::vector<double> par, perp; ///< of each bin; anything where it has no pair
  std::vector<double> count;     ///< pairs of each part, number bin * fine + part
  double molecules = 0;          ///< whose pairs they are
  double self = 0;               ///< the friction of a molecule, which its pairs' sum is to be

  double pairs(std::size_t bin) const;
  /// Sum of (par + 2 perp)/3 over a molecule's neighbours in the bins whose middles are below the cut-off.
  double sum(double cutoff) const;
};

/// A smooth friction of pairs: linear between the points, constant before the first, zero at the last.
struct FrictionTable {
  std::vector<double> r, par, perp;

  double cutoff() const { return r.back(); }
  double par_at(double at) const;
  double perp_at(double at) const;
};

/// The cubic splines of least squares over all pairs, each counting alike (one value along, two across), that
/// are nowhere negative, go to zero with their slope at the cut-off, and obey the sum rule: cg/README.md,
/// Eqs. (C28), (C29). `knots`: distance of the splines' knots. Throws InputError when fewer than 4 bins below
/// the cut-off hold pairs, or self <= 0.
FrictionTable friction_table(MeasuredFriction const& measured, double cutoff, double knots);

/// Sum over a molecule's neighbours of (par + 2 perp)/3 by the table.
double friction_sum(FrictionTable const& table, MeasuredFriction const& measured);

} // namespace mesobridge::cg
