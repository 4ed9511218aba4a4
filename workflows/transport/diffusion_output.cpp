#include "workflows/transport/diffusion_output.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/summary.hpp"
#include "workflows/transport/viscosity_output.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t most_curve_lags = 200;

/// Every so many lags, so that a curve has at most so many points, from the first on.
Series curve_of(cg::Diffusion const& found, std::string label,
                std::function<cg::Estimate(std::size_t)> const& of, std::size_t first, std::size_t last) {
  Series series{.label = std::move(label)};
  std::size_t const step = std::max<std::size_t>(1, (last - first) / most_curve_lags);
  for (std::size_t k = first; k <= last; k += step) {
    auto const at = of(k);
    series.x.push_back(found.lag[k]), series.y.push_back(at.mean), series.y_error.push_back(at.se);
  }
  return series;
}

Figure displacements(cg::Diffusion const& found) {
  Plot plot{.name = "displacements",
            .title = "Mean square displacement over 6 t",
            .x = {.label = "t"},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y = {.label = "Δ^2/6t", .min = 0};
  std::size_t const last = found.lag.size() - 1;
  panel.series = {
      curve_of(
          found, "mean of all",
          [&](std::size_t k) { return cg::scaled(found.displacement[k], 1 / (6 * found.lag[k])); }, 1, last),
      {.label = "D, from the slope of the second half",
       .x = {found.lag[last / 2], found.lag[last]},
       .y = {found.D.mean, found.D.mean},
       .y_error = {found.D.se, found.D.se},
       .style = SeriesStyle::band}};
  return {{draw_svg(plot)},
          "How far the centres of mass have come. What they had at the beginning stays in the curve; the "
          "slope of the "
          "second half is free of it."};
}

Figure velocities(cg::Diffusion const& found) {
  auto plot = one_panel("velocities", "Correlation of the velocities", "t", "C(t)/C(0)", {0});
  std::size_t shown = 1; // until it has died away
  while (shown + 1 < found.lag.size() &&
         found.lag[shown] < 12 * found.decay.value_or(cg::Estimate{found.lag.back()}).mean)
    ++shown;
  plot.panels[0].series = {curve_of(
      found, "", [&](std::size_t k) { return found.velocity[k]; }, 0, shown)};
  return {{draw_svg(plot)}, "Of the centres of mass, without the motion of all together."};
}

} // namespace

Json diffusion_json(cg::Diffusion const& found) {
  Json json;
  put(json, "D", found.D);
  put(json, "D_earlier", found.D_earlier);
  put(json, "temperature", found.temperature);
  if (found.decay)
    put(json, "velocity_decay_time", *found.decay);
  if (found.D_velocity)
    put(json, "D_velocity", *found.D_velocity);
  if (found.D_infinite)
    put(json, "D_infinite", *found.D_infinite);
  for (std::size_t k = 0; k < found.lag.size(); ++k) {
    json["lag"].push_back(found.lag[k]);
    json["displacement"].push_back(found.displacement[k].mean);
    json["displacement_se"].push_back(found.displacement[k].se);
    json["velocity_correlation"].push_back(found.velocity[k].mean);
    json["velocity_correlation_se"].push_back(found.velocity[k].se);
  }
  return json;
}

std::string diffusion_text(cg::Diffusion const& found) {
  auto text =
      fmt::format("D           {}  (from displacements over {:.4g} ... {:.4g}; over the lags before {})\n",
                  with_error_text(found.D), found.lag[(found.lag.size() - 1) / 2], found.lag.back(),
                  with_error_text(found.D_earlier));
  text +=
      found.D_velocity
          ? fmt::format("D           {}  (from velocities, which have fallen to 1/e after {})\n",
                        with_error_text(*found.D_velocity), with_error_text(*found.decay))
          : "            (the frames are too far apart, or the lags too short, to integrate velocities)\n";
  if (found.D_infinite)
    text +=
        fmt::format("D_infinite  {}  (without the images of the box)\n", with_error_text(*found.D_infinite));
  return text + fmt::format("T           {}  (of the motion; k_B T in reduced units)\n",
                            with_error_text(found.temperature));
}

Report transport_report(cg::Diffusion const& found, std::optional<cg::Viscosity> const& viscosity,
                        std::string const& name, std::string const& units) {
  Report report;
  report.title = "Diffusion and viscosity of " + name;
  report.lead =
      fmt::format("In units of {}: D = {} from displacements{}{}.", units, with_error_text(found.D),
                  found.D_velocity ? ", " + with_error_text(*found.D_velocity) + " from velocities" : "",
                  viscosity ? "; the shear viscosity is " + with_error_text(viscosity->eta) : "");
  report.sections = {{"Displacements", {displacements(found)}}, {"Velocities", {velocities(found)}}};
  if (viscosity) {
    report.sections.push_back(viscosity_section(*viscosity));
    report.sources.push_back("Palmer 1994");
  }
  if (found.D_infinite)
    report.sources.push_back("Yeh and Hummer 2004");
  return report;
}

} // namespace mesobridge::workflows
