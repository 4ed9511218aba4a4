#pragma once
#include <string>

namespace mesobridge::workflows {

/// The scale of maps and films, from dark violet over blue and green to yellow: the colour of a share
/// between 0 and 1, "#440154" ... "#fde725"; the ends beyond.
std::string scale_colour(double share);

/// gnuplot's words for the same scale.
std::string gnuplot_palette();

} // namespace mesobridge::workflows
