#include "workflows/lj_to_sdpd/results.hpp"
#include "workflows/sdpd/equilibrium_plots.hpp"
#include "workflows/size_study/report.hpp"

namespace mesobridge::workflows {
namespace {

/// As names of drawings want it: letters and digits.
std::string letters(std::string text) {
  std::erase(text, '-');
  return text;
}

Series points(SizeStudy const& study, std::string const& kernel, Treatment treatment,
              cg::Estimate FluidRun::*estimate, double unit) {
  Series series{.label = label_of(treatment), .colour = int(treatment)};
  for (auto const& run : study.runs)
    if (run.kernel == kernel && run.treatment == treatment) {
      series.x.push_back(run.K), series.y.push_back((run.*estimate).mean * unit);
      series.y_error.push_back((run.*estimate).se * unit);
    }
  return series;
}

Series printed(SizeStudy const& study, double ThesisMeans::*mean) {
  Series series{.label = "thesis, Table 5.1", .style = SeriesStyle::dashes, .colour = 3};
  double const low = study.sizes.front(), high = study.sizes.back();
  constexpr int steps = 60;
  for (int k = 0; k <= steps; ++k) {
    double const K = low * std::pow(high / low, double(k) / steps);
    series.x.push_back(K), series.y.push_back(thesis_means(K).*mean);
  }
  return series;
}

} // namespace

Plot against_size(SizeStudy const& study, SizeQuantity quantity, std::string const& kernel) {
  bool const pressure = quantity == SizeQuantity::pressure;
  double const eos = pressure ? study.P_eos / 1e9 : 1150;
  Plot plot{.name = (pressure ? "P" : "rho") + letters(kernel),
            .title = (pressure ? "Pressure, " : "Mean density, ") + kernel,
            .x = {.label = "particle size K",
                  .logarithmic = true,
                  .min = study.sizes.front() / 1.5,
                  .max = study.sizes.back() * 1.5},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = pressure ? "P [GPa]" : "rho [kg/m^3]";
  panel.level_lines = {eos};
  for (Treatment const treatment : treatments)
    panel.series.push_back(points(study, kernel, treatment, pressure ? &FluidRun::P : &FluidRun::rho, eos));
  panel.series.push_back(printed(study, pressure ? &ThesisMeans::pressure : &ThesisMeans::density));
  return plot;
}

Plot size_distributions(SizeStudy const& study, SizeQuantity quantity, std::string const& kernel) {
  bool const pressure = quantity == SizeQuantity::pressure;
  std::vector<LabelledSamples> samples;
  constexpr double narrow = 500; // larger particles' distributions are spikes on this scale
  for (auto const& run : study.runs)
    if (run.kernel == kernel && run.treatment == Treatment::free && run.K <= narrow)
      samples.push_back({fmt::format("K = {:g}", run.K), pressure ? run.P_i : run.rho_i});
  return distribution_plot((pressure ? "distP" : "distrho") + letters(kernel),
                           (pressure ? "Pressures of the particles, " : "Densities of the particles, ") +
                               kernel,
                           pressure ? "P [GPa]" : "rho [kg/m^3]", samples);
}

Plot radial_distributions(SizeStudy const& study) {
  Plot plot{.name = "gr",
            .title = fmt::format("Structure at K = {:g}", study.sizes.back()),
            .x = {.label = "r [mean spacings]"},
            .panels = {Panel{}}};
  plot.panels[0].y.label = "g(r)";
  plot.panels[0].level_lines = {1};
  for (auto const& structure : study.structures)
    plot.panels[0].series.push_back({.label = structure.kernel,
                                     .x = structure.r,
                                     .y = structure.g,
                                     .y_error = {},
                                     .style = SeriesStyle::lines});
  return plot;
}

} // namespace mesobridge::workflows
