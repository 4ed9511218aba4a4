#pragma once
#include "workflows/eos/columns.hpp"
#include "workflows/report/plot.hpp"
#include <functional>

namespace mesobridge::workflows {

/// The file that -o names for a curve: *.csv, *.svg or *.html. Throws InputError for another ending.
enum class CurveFile { csv, svg, html };
CurveFile curve_file(std::filesystem::path const& path);

/// Writes a curve to the file of -o, if one is given, as its ending says; the plot is only made when it is
/// needed. Names the file in the result.
void write_curve(Context const& context, Result& result, std::function<std::string()> const& csv,
                 std::function<Plot()> const& plot);

/// A curve's columns, into the result, too.
void put_curve(Context const& context, Result& result, Columns const& columns, bool reduced,
               std::function<Plot()> const& plot);

/// Pressures in plots are in GPa, or reduced.
double pressure_unit(bool reduced);
/// "P [GPa]" or "P*"; "rho [kg/m^3]" or "rho*".
std::string pressure_label(bool reduced);
std::string density_label(bool reduced);

/// P over rho of states, as a line.
Series pressure_series(std::string const& label, std::vector<fitting::EosState> const& states, bool reduced);
std::vector<fitting::EosState> states_behind(std::vector<fitting::Shock> const& shocks);

} // namespace mesobridge::workflows
