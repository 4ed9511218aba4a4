#pragma once
#include "cg/estimate.hpp"

namespace mesobridge::cg {

/// A pair potential at the middles of bins of equal width, r_k = (k + 1/2) width; zero from the cut-off on.
struct PairPotential {
  double width = 0; ///< > 0
  std::vector<double> u;

  double r(std::size_t k) const { return (double(k) + 0.5) * width; }
  double cutoff() const { return width * double(u.size()); }
};

/// A radial distribution function in bins of equal width from r = 0 on.
struct RadialBins {
  double width = 0;
  std::vector<double> g;
};

struct InversionSettings {
  double kT = 1;         ///< > 0
  double cutoff = 0;     ///< of the potential, within the bins of g
  double share = 0.5;    ///< of the full change that an update makes, in (0, 1]
  double knots = 0.25;   ///< distance of the knots of the smoothing splines
  double density = 0;    ///< particles per volume, to count neighbours' neighbours (Eq. (C23)); 0: do not
  double least_g = 1e-3; ///< below it g says nothing: there the potential goes on as a + b r^2
  double least_pairs =
      0; ///< of g r^2 over its largest value: below it a measured bin holds a few pairs by chance
};

/// -kT ln g, smoothed, continued into the core and shifted to zero at the cut-off: where the iteration begins
/// (cg/README.md, Eq. (C20)). Throws InputError for settings out of range or a g without values in it.
PairPotential boltzmann_potential(RadialBins const& target, InversionSettings const& settings);

/// One step of iterative Boltzmann inversion (Eq. (C21)), or with a density the one that counts neighbours'
/// neighbours too (Eq. (C23)), from what particles with the potential show. Throws
/// InputError when the bins differ.
PairPotential inverted(PairPotential const& before, RadialBins const& target, RadialBins const& now,
                       InversionSettings const& settings);

/// What a change of the potential makes of the virial pressure while g stays. `density`: particles per
/// volume.
double pressure_change(PairPotential const& before, PairPotential const& after, RadialBins const& now,
                       double density);

/// Adds A (1 - r/r_c), which takes `excess` of the pressure away while g stays, but for |A| <= most (Eq.
/// (C22)).
PairPotential with_less_pressure(PairPotential const& before, RadialBins const& now, double density,
                                 double excess, double most);

/// The next potential to try: `inverted`, and such an A that the pressure loses its `excess` in all; A may
/// undo what the inversion does to the pressure, and 0.3 kT besides.
PairPotential inverted_at_pressure(PairPotential const& before, RadialBins const& target,
                                   RadialBins const& now, InversionSettings const& settings, double density,
                                   double excess);

/// The direct correlation function of Ornstein and Zernike's equation at the middles of the bins, which must
/// reach to where g is 1 (Eq. (C23)). `least_S`: what structure factors below it, noise, count as; > 0 where
/// g is measured.
std::vector<double> direct_correlation(RadialBins const& bins, double density, double least_S = 0);

/// int (g - g_target)^2 r^2 dr/int g_target^2 r^2 dr over the bins of both.
double g_difference(RadialBins const& target, RadialBins const& now);

} // namespace mesobridge::cg
