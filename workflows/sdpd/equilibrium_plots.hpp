#pragma once
#include "workflows/report/plot.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// Samples of one quantity and how they are called in the legend.
struct LabelledSamples {
  std::string label;
  std::span<double const> values;
  double divide_by = 1; ///< for the axis's unit
};

/// Histograms of several samples over their common range, as steps.
Plot distribution_plot(std::string const& name, std::string const& title, std::string const& axis,
                       std::vector<LabelledSamples> const& samples);

/// The relative energy error against time for several runs.
Plot energy_error_plot(std::string const& name,
                       std::vector<std::pair<std::string, RunResult const*>> const& runs);

/// The law of the internal energy of an ideal-gas particle, Gamma(C_K/k_B, k_B T) in units of k_B T
/// (sdpd/README.md, Eq. (S19)), at the centres of a histogram: a curve to lay over it.
Series gamma_law(double K, double x_min, double x_max, int colour);

} // namespace mesobridge::workflows
