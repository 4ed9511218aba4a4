#pragma once
#include "workflows/report/plot.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// "T_kin_K" as an axis names it, and the factor from the column's unit to the axis's: {"T_kin [K]", 1},
/// {"P [GPa]", 1e-9}. Names without a known unit stay as they are.
struct AxisOfColumn {
  std::string label;
  double factor;
};
AxisOfColumn axis_of(std::string const& column);

/// At most `most` means of neighbouring values, in their order.
std::vector<double> thinned(std::vector<double> const& values, std::size_t most);

std::vector<double> scaled(std::vector<double> values, double factor);

/// A name for drawings: the letters and digits of a text.
std::string drawing_name(std::string text);

/// A series against time in one colour, and its mean as dashes with its error as a band in the next.
void add_curve_with_mean(Panel& panel, std::string const& name, std::vector<double> const& time,
                         std::vector<double> const& values, cg::Estimate const& mean, int colour);

/// The series of a run's file against time, each with its mean ± standard error over the run: the
/// temperatures, the pressure and the mean density.
std::vector<Plot> time_series_plots(std::filesystem::path const& run_file, RunResult const& run);

/// The profiles that the scene asks for, each averaged over the run, with the standard errors of the means;
/// none if it asks for none.
std::vector<Plot> profile_plots(std::filesystem::path const& run_file, RunResult const& run);

/// The histograms that the scene asks for, summed over the run; none if it asks for none.
std::vector<Plot> histogram_plots(std::filesystem::path const& run_file, RunResult const& run);

} // namespace mesobridge::workflows
