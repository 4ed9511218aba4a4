#pragma once
#include <string>

namespace mesobridge::workflows {

/// What gnuplot draws by a script, which sets its SVG terminal's name to `name`: an SVG element without XML
/// prolog, whose title is `described`. Throws EnvironmentError with gnuplot's own words if it fails.
std::string gnuplot_svg(std::string const& script, std::string const& name, std::string const& described);

} // namespace mesobridge::workflows
