#include "workflows/transport/beside.hpp"
#include "md/error.hpp"
#include "workflows/json_file.hpp"
#include "workflows/report/check.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t most_points = 150;

/// What can be compared, in the order of the table, and what it is called there.
constexpr std::pair<char const*, char const*> compared[] = {
    {"D", "D, from displacements"},
    {"D_velocity", "D, from velocities"},
    {"D_infinite", "D, without the images of the box"},
    {"eta", "shear viscosity"},
    {"velocity_decay_time", "time in which velocities fall to 1/e"},
    {"temperature", "temperature of the motion"}};

double number_in(Json const& json, std::string const& what, std::filesystem::path const& file) {
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    throw InputError(fmt::format("'{}': {} must be a number", file.string(), what));
  return json.get<double>();
}

std::string text_in(Json const& json, char const* key, std::filesystem::path const& file) {
  if (!json.contains(key) || !json[key].is_string())
    throw InputError(fmt::format("'{}' has no text '{}': is it a transport.json of this version of `cg "
                                 "transport`?",
                                 file.string(), key));
  return json[key].get<std::string>();
}

std::vector<double> row_in(Json const& json, std::string const& key, std::size_t count,
                           std::filesystem::path const& file) {
  if (!json.contains(key) || !json[key].is_array() || json[key].size() < 5 ||
      (count > 0 && json[key].size() != count))
    throw InputError(fmt::format("'{}' has no row '{}' of as many numbers as lags", file.string(), key));
  std::vector<double> row;
  for (auto const& value : json[key])
    row.push_back(number_in(value, key, file));
  return row;
}

std::vector<cg::Estimate> curve_in(Json const& json, std::string const& key, std::size_t count,
                                   std::filesystem::path const& file) {
  auto const mean = row_in(json, key, count, file), se = row_in(json, key + "_se", count, file);
  std::vector<cg::Estimate> curve;
  for (std::size_t k = 0; k < count; ++k)
    curve.push_back({mean[k], se[k]});
  return curve;
}

/// A number that both have: what it is, ours and the other's.
struct Pair {
  std::string key, what;
  cg::Estimate ours, other;

  double difference_in_se() const { return deviation(Comparison{what, ours, other}); }
};

std::vector<Pair> pairs_of(TransportResult const& ours, TransportResult const& other) {
  std::vector<Pair> pairs;
  for (auto const& [key, what] : compared) {
    auto const in = [&key = key](TransportResult const& result) {
      return std::ranges::find(result.numbers, key, [](auto const& number) { return number.first; });
    };
    if (in(ours) != ours.numbers.end() && in(other) != other.numbers.end())
      pairs.push_back({key, what, in(ours)->second, in(other)->second});
  }
  return pairs;
}

void require_same_units(TransportResult const& ours, TransportResult const& other) {
  require(ours.units == other.units, "units of the transport beside", other.units,
          fmt::format("must be {}, those of this one", ours.units));
}

/// When a velocity has fallen to 1/e, to the next lag.
double decay_of(TransportResult const& result) {
  auto const at =
      std::ranges::find_if(result.velocity, [](auto const& C) { return C.mean < 1 / std::numbers::e; });
  return result.lag[std::min(std::size_t(at - result.velocity.begin()), result.lag.size() - 1)];
}

/// The lags until both velocities have died away: 12 times the longer decay, or as far as both reach.
double shown_lags(TransportResult const& ours, TransportResult const& other) {
  return std::min({ours.lag.back(), other.lag.back(), 12 * std::max(decay_of(ours), decay_of(other))});
}

/// Of this fluid points with errors, of the one beside it a line.
Series curve(TransportResult const& of, std::vector<cg::Estimate> const& values, double last, bool per_time,
             SeriesStyle style) {
  Series series{.label = of.name, .style = style};
  auto const count = std::size_t(std::ranges::upper_bound(of.lag, last * (1 + 1e-9)) - of.lag.begin());
  std::size_t const step = 1 + count / most_points;
  for (std::size_t k = per_time ? 1 : 0; k < count; k += step) {
    double const factor = per_time ? 1 / (6 * of.lag[k]) : 1;
    series.x.push_back(of.lag[k]), series.y.push_back(factor * values[k].mean);
    if (style == SeriesStyle::points)
      series.y_error.push_back(factor * values[k].se);
  }
  return series;
}

} // namespace

TransportResult transport_result(Json const& json, std::filesystem::path const& file) {
  if (!json.is_object())
    throw InputError(fmt::format("'{}' is no transport.json", file.string()));
  TransportResult result{.name = text_in(json, "name", file), .units = text_in(json, "units", file)};
  for (auto const& [key, what] : compared)
    if (json.contains(key)) {
      auto const se_key = std::string(key) + "_se";
      double const se = number_in(json.value(se_key, Json()), se_key, file);
      require(se > 0, fmt::format("{} of '{}'", se_key, file.string()), se, "must be > 0");
      result.numbers.emplace_back(key, cg::Estimate{number_in(json[key], key, file), se});
    }
  result.lag = row_in(json, "lag", 0, file);
  if (!std::ranges::is_sorted(result.lag))
    throw InputError(fmt::format("'{}': its lags must grow", file.string()));
  result.displacement = curve_in(json, "displacement", result.lag.size(), file);
  result.velocity = curve_in(json, "velocity_correlation", result.lag.size(), file);
  return result;
}

std::filesystem::path transport_file(std::filesystem::path const& file_or_folder) {
  return std::filesystem::is_directory(file_or_folder) ? file_or_folder / "transport.json" : file_or_folder;
}

TransportResult read_transport(std::filesystem::path const& file_or_folder) {
  auto const file = transport_file(file_or_folder);
  return transport_result(read_json(file), file);
}

Json beside_json(TransportResult const& ours, TransportResult const& other) {
  require_same_units(ours, other);
  Json json{{"name", other.name}};
  for (auto const& pair : pairs_of(ours, other)) {
    json[pair.key] = pair.other.mean, json[pair.key + "_se"] = pair.other.se;
    if (pair.other.mean != 0)
      json[pair.key + "_ratio"] = pair.ours.mean / pair.other.mean;
    json[pair.key + "_difference_in_se"] = pair.difference_in_se();
  }
  return json;
}

std::string beside_text(TransportResult const& ours, TransportResult const& other) {
  std::string text = fmt::format("beside {}:\n", other.name);
  for (auto const& pair : pairs_of(ours, other))
    text += fmt::format("  {:<38}{}, there {}: {:+.1f} standard errors\n", pair.what,
                        with_error_text(pair.ours), with_error_text(pair.other), pair.difference_in_se());
  return text;
}

Section beside_section(TransportResult const& ours, TransportResult const& other) {
  Table table{.header = {"", ours.name, other.name, "difference", "in standard errors"}};
  for (auto const& pair : pairs_of(ours, other))
    table.rows.push_back({pair.what, with_error_text(pair.ours), with_error_text(pair.other),
                          fmt::format("{:+.1f} %", 100 * (pair.ours.mean / pair.other.mean - 1)),
                          fmt::format("{:+.1f}", pair.difference_in_se())});
  auto velocities = one_panel("velocitiesbeside", "Correlation of the velocities", "t", "C(t)/C(0)", {0});
  double const shown = shown_lags(ours, other);
  velocities.panels[0].series = {curve(ours, ours.velocity, shown, false, SeriesStyle::points),
                                 curve(other, other.velocity, shown, false, SeriesStyle::lines)};
  Plot displacements{.name = "displacementsbeside",
                     .title = "Mean square displacement over 6 t",
                     .x = {.label = "t"},
                     .panels = {Panel{}}};
  displacements.panels[0].y = {.label = "Δ^2/6t", .min = 0};
  double const last = std::min(ours.lag.back(), other.lag.back());
  displacements.panels[0].series = {curve(ours, ours.displacement, last, true, SeriesStyle::points),
                                    curve(other, other.displacement, last, true, SeriesStyle::lines)};
  return {
      "Beside " + other.name,
      {std::move(table),
       Figure{
           {draw_svg(velocities), draw_svg(displacements)},
           "The motion of both, by the same code; points with standard errors, and a line for the other."}}};
}

} // namespace mesobridge::workflows
