#include "workflows/sdpd/run_plots.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/scene/quantities.hpp"
#include "workflows/sdpd/run_file.hpp"
#include "workflows/sdpd/short_series.hpp"
#include <algorithm>
#include <array>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t most_curve_points = 400; ///< of a curve: more cannot be seen, and make a report heavy

/// Columns of a table of rows, by their names.
std::vector<double> column(std::vector<double> const& rows, std::vector<std::string> const& names,
                           std::string const& name) {
  auto const found = std::ranges::find(names, name);
  std::vector<double> values;
  if (found == names.end())
    return values;
  for (auto r = static_cast<std::size_t>(found - names.begin()); r < rows.size(); r += names.size())
    values.push_back(rows[r]);
  return values;
}

/// The mean of a series as a line with its error as a band, over the times of the series.
void add_mean(Panel& panel, std::string const& name, cg::Estimate const& mean,
              std::vector<double> const& time, int colour) {
  std::vector<double> const ends{time.front(), time.back()}, level{mean.mean, mean.mean};
  panel.series.push_back({.label = "",
                          .x = ends,
                          .y = level,
                          .y_error = {mean.se, mean.se},
                          .style = SeriesStyle::band,
                          .colour = colour});
  panel.series.push_back({.label = fmt::format("mean {} = {}", plain(name), with_error_text(mean)),
                          .x = ends,
                          .y = level,
                          .y_error = {},
                          .style = SeriesStyle::dashes,
                          .colour = colour});
}

/// A dataset with one row a profile: of each slice one number, or one of the components that it has.
class Rows {
 public:
  Rows(std::vector<double> values, std::size_t slices, std::size_t components = 1, std::size_t component = 0)
      : values_(std::move(values)), slices_(slices), components_(components), component_(component) {}
  std::size_t count() const { return values_.size() / (slices_ * components_); }
  std::size_t slices() const { return slices_; }
  double operator()(std::size_t row, std::size_t slice) const {
    return values_[(row * slices_ + slice) * components_ + component_];
  }

 private:
  std::vector<double> values_;
  std::size_t slices_, components_, component_;
};

/// Means over the profiles in which a slice has enough particles for the quantity.
Series mean_profile(Rows const& rows, Rows const& number, double least_number,
                    std::vector<double> const& position, double factor) {
  Series series{.label = ""};
  for (std::size_t slice = 0; slice < rows.slices(); ++slice) {
    std::vector<double> values;
    for (std::size_t r = 0; r < rows.count(); ++r)
      if (number(r, slice) >= least_number)
        values.push_back(factor * rows(r, slice));
    if (values.empty())
      continue;
    auto const mean = mean_of_series(values);
    series.x.push_back(position[slice]), series.y.push_back(mean.mean), series.y_error.push_back(mean.se);
  }
  return series;
}

std::string key_of(std::string const& quantity, OutputUnits const& units) {
  if (auto const field = std::ranges::find(sdpd::fields, quantity, &sdpd::Field::name);
      field != sdpd::fields.end())
    return units.of(field->dimension).second;
  if (quantity == "velocity")
    return units.velocity_key;
  return quantity.starts_with("T") ? units.temperature_key : units.pressure_key;
}

Plot profile_frame(std::string const& quantity, std::string const& x, std::string const& y) {
  Plot plot{.name = drawing_name("profile" + quantity),
            .title = "Profile of " + plain(quantity) + ", mean of the run",
            .x = {.label = x},
            .panels = {Panel{}}};
  plot.panels[0].y.label = y;
  return plot;
}

} // namespace

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values)
    value *= factor;
  return values;
}

std::string drawing_name(std::string text) {
  std::erase_if(text, [](unsigned char c) { return !std::isalnum(c); });
  return text;
}

AxisOfColumn axis_of(std::string const& column) {
  struct Unit {
    std::string_view key, shown;
    double factor;
  };
  static constexpr std::array<Unit, 8> units{{{"_kg_m3", "kg/m^3", 1},
                                              {"_J_kg", "J/kg", 1},
                                              {"_m_s", "m/s", 1},
                                              {"_Pa", "GPa", 1e-9},
                                              {"_K", "K", 1},
                                              {"_J", "10^{-21} J", 1e21},
                                              {"_m", "nm", 1e9},
                                              {"_s", "ps", 1e12}}};
  for (auto const& [key, shown, factor] : units)
    if (column.size() > key.size() && column.ends_with(key))
      return {fmt::format("{} [{}]", plain(column.substr(0, column.size() - key.size())), shown), factor};
  return {plain(column), 1};
}

std::vector<double> thinned(std::vector<double> const& values, std::size_t most) {
  std::size_t const each = (values.size() + most - 1) / std::max<std::size_t>(most, 1);
  if (each <= 1)
    return values;
  std::vector<double> means;
  for (std::size_t k = 0; k < values.size(); k += each) {
    std::size_t const count = std::min(each, values.size() - k);
    means.push_back(gsl_stats_mean(values.data() + k, 1, count));
  }
  return means;
}

void add_curve_with_mean(Panel& panel, std::string const& name, std::vector<double> const& time,
                         std::vector<double> const& values, cg::Estimate const& mean, int colour) {
  panel.series.push_back({.label = plain(name),
                          .x = thinned(time, most_curve_points),
                          .y = thinned(values, most_curve_points),
                          .y_error = {},
                          .style = SeriesStyle::lines,
                          .colour = colour});
  add_mean(panel, name, mean, time, colour + 1);
}

std::vector<Plot> time_series_plots(std::filesystem::path const& run_file, RunResult const& run) {
  OutputUnits const units(run.settings.units(), run.scene.units);
  auto const names = RunFile::column_names(units, run.settings.features());
  auto const rows = Store(run_file, Store::Mode::read).read_doubles("thermodynamics");
  auto const time_axis = axis_of("time" + units.time_key);
  auto const time = scaled(column(rows, names, "time" + units.time_key), time_axis.factor);
  struct Wanted {
    std::string title, key;
    std::vector<std::string> quantities;
  };
  std::vector<Plot> plots;
  for (auto const& [title, key, quantities] :
       {Wanted{"Temperatures", units.temperature_key, {"T_kin", "T_int"}},
        Wanted{"Pressure", units.pressure_key, {"P"}}, Wanted{"Mean density", units.density_key, {"rho"}}}) {
    Plot plot{.name = drawing_name("time" + title),
              .title = title + " in time",
              .x = {.label = time_axis.label},
              .panels = {Panel{}}};
    auto& panel = plot.panels[0];
    int colour = 0;
    for (auto const& quantity : quantities) {
      auto const axis = axis_of(quantity + key);
      auto const values = scaled(column(rows, names, quantity + key), axis.factor);
      if (values.empty())
        continue; // the method has no such quantity
      panel.y.label = quantities.size() > 1 ? axis_of("T" + key).label : axis.label;
      add_curve_with_mean(panel, quantity, time, values, cg::estimate_mean(values), colour);
      colour += 2;
    }
    if (!panel.series.empty())
      plots.push_back(std::move(plot));
  }
  return plots;
}

std::vector<Plot> profile_plots(std::filesystem::path const& run_file, RunResult const& run) {
  Store const store(run_file, Store::Mode::read);
  if (run.scene.profile.every == 0 || !store.contains("profile/number"))
    return {};
  OutputUnits const units(run.settings.units(), run.scene.units);
  auto const& axis = run.scene.profile.axis;
  auto const place = axis_of(axis + units.length_key);
  auto const position = scaled(store.read_doubles("profile/position" + units.length_key), place.factor);
  auto const counts = store.read_integers("profile/number");
  Rows const number({counts.begin(), counts.end()}, position.size());
  std::vector<Plot> plots;
  for (auto const& quantity :
       chosen(run.scene.profile.quantities, profile_quantities(), run.scene.features())) {
    auto const key = key_of(quantity, units);
    auto const y = axis_of(quantity + key);
    auto plot = profile_frame(quantity, place.label, y.label);
    auto const dataset = "profile/" + quantity + key;
    std::size_t const components = quantity == "velocity" ? 3 : 1;
    double const least = quantity == "T_kin" ? 2 : 1;
    for (std::size_t c = 0; c < components; ++c) {
      auto series = mean_profile(Rows(store.read_doubles(dataset), position.size(), components, c), number,
                                 least, position, y.factor);
      if (components > 1)
        series.label = fmt::format("along {}", "xyz"[c]);
      plot.panels[0].series.push_back(std::move(series));
    }
    if (std::ranges::any_of(plot.panels[0].series, [](auto const& series) { return !series.x.empty(); }))
      plots.push_back(std::move(plot));
  }
  return plots;
}

std::vector<Plot> histogram_plots(std::filesystem::path const& run_file, RunResult const& run) {
  Store const store(run_file, Store::Mode::read);
  if (run.scene.histogram.every == 0 || !store.contains("histogram/step"))
    return {};
  OutputUnits const units(run.settings.units(), run.scene.units);
  std::vector<Plot> plots;
  for (auto const& quantity :
       chosen(run.scene.histogram.quantities, histogram_quantities(), run.scene.features())) {
    auto const name = quantity + key_of(quantity, units), group = "histogram/" + name;
    auto const axis = axis_of(name);
    auto const edges = scaled(store.read_doubles(group + "/edges"), axis.factor);
    auto const counts = store.read_integers(group + "/counts");
    std::size_t const bins = edges.size() - 1;
    std::vector<double> sum(bins, 0.0);
    double outside = 0;
    for (std::size_t k = 0; k < counts.size(); ++k)
      sum[k % bins] += static_cast<double>(counts[k]);
    for (char const* const side : {"/below", "/above"})
      for (auto const count : store.read_integers(group + side))
        outside += static_cast<double>(count);
    double total = outside;
    for (double const count : sum)
      total += count;
    Series series{.label = "", .style = SeriesStyle::steps};
    for (std::size_t b = 0; b < bins; ++b) {
      series.x.push_back((edges[b] + edges[b + 1]) / 2);
      series.y.push_back(sum[b] / (total * (edges[b + 1] - edges[b])));
    }
    Plot plot{.name = drawing_name("histogram" + quantity),
              .title =
                  fmt::format("Distribution of {} over {} histograms", plain(quantity), counts.size() / bins),
              .x = {.label = axis.label},
              .panels = {Panel{}}};
    plot.panels[0].y.label = "probability density";
    plot.panels[0].series.push_back(std::move(series));
    plots.push_back(std::move(plot));
  }
  return plots;
}

} // namespace mesobridge::workflows
