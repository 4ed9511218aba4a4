#pragma once
#include <string>

namespace mesobridge::workflows {

/// The colour of a share between 0 and 1 of the scale of maps and films, "#440154" ... "#fde725"; the ends
/// beyond.
std::string scale_colour(double share);

/// The same scale as gnuplot's palette: "defined (0 '#440154', ...)".
std::string gnuplot_scale();

} // namespace mesobridge::workflows
