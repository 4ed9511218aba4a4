#include "workflows/coarse/cost_section.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

std::string share_text(double share) {
  return fmt::format("{:g} %", 100 * share);
}

std::string name_of(CoarseRun const& run) {
  return fmt::format("Δt = {:g}{}", run.dt, run.model.empty() ? "" : ", model of " + run.name.substr(4));
}

/// "+1.4(2) %", or nothing where the run does not have it.
std::string apart_text(KeptRun const& run, std::string const& key) {
  auto const found = std::ranges::find(run.quantities, key, &KeptQuantity::key);
  if (found == run.quantities.end())
    return "";
  double const scale = 100 / std::abs(found->molecules.mean);
  return with_error_text({scale * (found->particles.mean - found->molecules.mean),
                          scale * std::hypot(found->particles.se, found->molecules.se)});
}

Table runs_table(Kept const& kept) {
  Table table{.header = {"run", "ms", "faster", "g(r)", "P", "T of the motion", "D", "velocity to 1/e", "η"},
              .caption = "Processor time for a particle and unit of time, how much less that is than the "
                         "molecules take, the root mean square difference of g in % of it, and differences "
                         "from the molecules in %."};
  table.rows.push_back({"molecules", number_text(1e3 * kept.cost_molecules, 3), "1", "", "", "", "", "", ""});
  for (auto const& run : kept.runs)
    table.rows.push_back({name_of(run.run), number_text(1e3 * run.cost, 3),
                          number_text(kept.speed_up(run), 3), number_text(100 * run.g.share.mean, 2),
                          apart_text(run, "P"), apart_text(run, "T_kin"), apart_text(run, "D"),
                          apart_text(run, "velocity_decay_time"), apart_text(run, "eta")});
  return table;
}

std::string time_text(std::optional<double> const& seconds) {
  return seconds ? number_text(*seconds, 2) : "never";
}

/// Of the run of the model that was found here.
Table times_table(Kept const& kept) {
  constexpr std::array errors{0.1, 0.05, 0.02, 0.01};
  Table table{
      .header = {"", "bias"},
      .caption = "Processor time in seconds until a mean is known within an error: by molecular dynamics / "
                 "by the particles, whose bias counts as an error and is what their difference shows beyond "
                 "chance. By the errors of these runs and the root of time: less than a run takes to come to "
                 "rest is arithmetic."};
  for (double const error : errors)
    table.header.push_back(share_text(error));
  for (auto const& of : kept.own().quantities) {
    auto const molecules = accuracy_of_molecules(kept, of), particles = accuracy_of_particles(kept.own(), of);
    table.rows.push_back({of.what, fmt::format("{:.2g} %", 100 * particles.bias)});
    for (double const error : errors)
      table.rows.back().push_back(time_text(molecules.time_for(error)) + " / " +
                                  time_text(particles.time_for(error)));
  }
  return table;
}

/// Error of one quantity after a processor time, of the molecules and of each run.
std::optional<std::string> error_figure(Kept const& kept, std::string const& key, char const* title) {
  Plot plot{.name = "error_of_" + key,
            .title = title,
            .x = {.label = "processor time [s]", .logarithmic = true},
            .panels = {Panel{}}};
  plot.panels[0].y = {.label = "error", .logarithmic = true};
  auto const add = [&](std::string label, Accuracy const& of) {
    Series series{.label = std::move(label), .style = SeriesStyle::lines};
    for (double seconds = 0.1; seconds < 2e4; seconds *= 1.25)
      series.x.push_back(seconds), series.y.push_back(of.error(seconds));
    plot.panels[0].series.push_back(std::move(series));
  };
  for (auto const& run : kept.runs)
    if (auto const found = std::ranges::find(run.quantities, key, &KeptQuantity::key);
        found != run.quantities.end()) {
      if (plot.panels[0].series.empty())
        add("molecules", accuracy_of_molecules(kept, *found));
      add(name_of(run.run), accuracy_of_particles(run, *found));
    }
  return plot.panels[0].series.empty() ? std::nullopt : std::optional(draw_svg(plot));
}

} // namespace

double Accuracy::error(double after) const {
  return std::sqrt(bias * bias + se * se * seconds / after);
}

std::optional<double> Accuracy::time_for(double error) const {
  double const left = error * error - bias * bias;
  return left > 0 ? std::optional(seconds * se * se / left) : std::nullopt;
}

Accuracy accuracy_of_molecules(Kept const& kept, KeptQuantity const& of) {
  return {kept.seconds_molecules, of.molecules.se / std::abs(of.molecules.mean), 0};
}

Accuracy accuracy_of_particles(KeptRun const& run, KeptQuantity const& of) {
  double const apart = of.particles.mean - of.molecules.mean,
               chance = std::hypot(of.particles.se, of.molecules.se), scale = std::abs(of.molecules.mean);
  return {run.seconds, of.particles.se / scale,
          std::sqrt(std::max(0.0, apart * apart - chance * chance)) / scale};
}

Section cost_section(Kept const& kept) {
  Section section{"Cost against error", {runs_table(kept)}};
  Figure figure{{}, "What is known after a processor time: chance falls with its root, a bias stays."};
  for (auto const& [key, title] : {std::pair("P", "Pressure"), std::pair("D", "Diffusion")})
    if (auto svg = error_figure(kept, key, title))
      figure.svgs.push_back(std::move(*svg));
  section.content.emplace_back(std::move(figure));
  section.content.emplace_back(times_table(kept));
  return section;
}

} // namespace mesobridge::workflows
