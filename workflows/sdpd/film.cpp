#include "workflows/sdpd/film.hpp"
#include "md/error.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/film_series.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t most_frames = 12, most_film_points = 6000;

/// The value below which a share of all are.
double quantile(std::vector<double> values, double share) {
  auto const at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

/// The box along an axis, widened to hold nearly all particles where they may leave it.
std::pair<double, double> extent(double edge, bool open, std::vector<double> const& places) {
  if (!open)
    return {0, edge};
  return {std::min(0.0, quantile(places, 0.005)), std::max(edge, quantile(places, 0.995))};
}

/// Every k-th frame, the last among them.
void thin_frames(FilmStrip& strip) {
  std::size_t const n = strip.frames.size();
  if (n <= most_frames)
    return;
  std::vector<FilmStrip::Frame> kept;
  for (std::size_t k = 0; k < most_frames; ++k)
    kept.push_back(std::move(strip.frames[k * (n - 1) / (most_frames - 1)]));
  strip.frames = std::move(kept);
}

/// Every k-th point of frames that have too many for a page.
bool thin_points(FilmStrip& strip) {
  bool thinned = false;
  for (auto& frame : strip.frames) {
    std::size_t const step = (frame.x.size() + most_film_points - 1) / most_film_points;
    if (step < 2)
      continue;
    thinned = true;
    for (auto* values : {&frame.x, &frame.y, &frame.value}) {
      std::size_t kept = 0;
      for (std::size_t k = 0; k < values->size(); k += step)
        (*values)[kept++] = (*values)[k];
      values->resize(kept);
    }
  }
  return thinned;
}

} // namespace

std::optional<FilmStrip> film_of(Store const& store, Scene const& scene,
                                 sdpd::SimulationSettings const& settings) {
  if (!scene.film.quantity || !store.contains("film/end"))
    return std::nullopt;
  OutputUnits const units(settings.units(), scene.units);
  auto const view = film_view(scene, settings);
  auto const column = film_column(*scene.film.quantity, units).name;
  auto const place = [&](int axis) { return std::string(1, "xyz"[axis]) + units.length_key; };
  if (!store.contains("film/" + column))
    return std::nullopt;
  auto const x = axis_of(place(view.right)), y = axis_of(place(view.up)), value = axis_of(column),
             t = axis_of("time" + units.time_key);
  auto const xs = scaled(store.read_doubles("film/" + place(view.right)), x.factor),
             ys = scaled(store.read_doubles("film/" + place(view.up)), y.factor),
             values = scaled(store.read_doubles("film/" + column), value.factor),
             times = scaled(store.read_doubles("film/time" + units.time_key), t.factor);
  auto const open = sdpd::open_axes(settings.faces);
  Vec3 const edge = units.length * sdpd::box_of(settings).edge;
  auto const [x_from, x_to] =
      extent(component(edge, view.right) * x.factor, open[static_cast<std::size_t>(view.right)], xs);
  auto const [y_from, y_to] =
      extent(component(edge, view.up) * y.factor, open[static_cast<std::size_t>(view.up)], ys);
  FilmStrip strip{.name = "film",
                  .title = with_raised_numbers(value.label) + " of the particles of a slab",
                  .x_label = x.label,
                  .y_label = y.label,
                  .value_label = with_raised_numbers(value.label),
                  .x_from = x_from,
                  .x_to = x_to,
                  .y_from = y_from,
                  .y_to = y_to,
                  .value_from = quantile(values, 0.02),
                  .value_to = quantile(values, 0.98),
                  .point_size = 0.7 * settings.spacing() * units.length * x.factor,
                  .frames = {}};
  std::size_t begin = 0, frame = 0;
  std::string const unit = units.time_key.empty() ? "" : " ps";
  for (auto const last : store.read_integers("film/end")) {
    auto const end = std::min(static_cast<std::size_t>(last), xs.size());
    auto const part = [&](std::vector<double> const& of) {
      return std::vector<double>(of.begin() + static_cast<std::ptrdiff_t>(begin),
                                 of.begin() + static_cast<std::ptrdiff_t>(end));
    };
    strip.frames.push_back(
        {"t = " + number_text(times.at(frame++), 3) + unit, part(xs), part(ys), part(values)});
    begin = end;
  }
  return strip;
}

std::optional<Section> film_section(Store const& store, Scene const& scene,
                                    sdpd::SimulationSettings const& settings) {
  auto strip = film_of(store, scene, settings);
  if (!strip)
    return std::nullopt;
  thin_frames(*strip);
  bool const thinned = thin_points(*strip);
  auto const view = film_view(scene, settings);
  OutputUnits const units(settings.units(), scene.units);
  auto const length = axis_of("z" + units.length_key);
  double const thickness = (view.upper - view.lower) * units.length * length.factor;
  std::string const caption =
      fmt::format("Particles of a slab of the thickness {}{} in the middle of the box, seen along {}{}. The "
                  "colours span from the 2nd to the 98th percentile of all frames' particles.",
                  number_text(thickness, 3), units.length_key.empty() ? "" : " nm", "xyz"[view.along],
                  thinned ? "; every few particles one is drawn" : "");
  return Section{"Film", {Figure{{draw_svg(*strip)}, caption}}};
}

std::size_t write_film_frames(std::filesystem::path const& run_folder, Scene const& scene,
                              sdpd::SimulationSettings const& settings) {
  Store const store(RunFolder(run_folder).run_file(), Store::Mode::read);
  auto const strip = film_of(store, scene, settings);
  if (!strip)
    return 0;
  auto const folder = run_folder / "frames";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot make '{}': {}", folder.string(), error.message()));
  for (std::size_t k = 0; k < strip->frames.size(); ++k)
    draw_png(*strip, k, (folder / fmt::format("frame-{:04}.png", k + 1)).string());
  return strip->frames.size();
}

} // namespace mesobridge::workflows
