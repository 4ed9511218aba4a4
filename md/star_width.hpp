#pragma once
#include "md/star_polymer.hpp"

namespace mesobridge::md {

/// Estimates of how wide stars are, along the longest of the three axes [sigma], at the temperature T > 0 in
/// a melt or alone.
struct StarWidth {
  double mean; ///< not less than the mean of a melt's molecules
  double rare; ///< hardly ever is one wider
};

StarWidth star_width(StarPolymer const& star, double T);

/// Edge of the smallest box for a melt of them: half of it holds them on average, and none reaches its own
/// image.
double smallest_edge(StarPolymer const& star, double T);

} // namespace mesobridge::md
