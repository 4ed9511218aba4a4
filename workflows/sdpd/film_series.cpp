#include "workflows/sdpd/film_series.hpp"
#include "workflows/sdpd/last_step.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

std::string const film_group = "film";

/// The components of the velocity come beside the fields.
std::optional<int> velocity_axis(std::string const& quantity) {
  return quantity.starts_with("velocity_") ? std::optional(quantity.back() - 'x') : std::nullopt;
}

std::vector<double> values_of(sdpd::Snapshot const& now, std::string const& quantity) {
  if (auto const axis = velocity_axis(quantity)) {
    std::vector<double> values(now.p.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = component(now.p[i], *axis) / now.mass_of(i);
    return values;
  }
  return now.*std::ranges::find(sdpd::fields, quantity, &sdpd::Field::name)->values;
}

} // namespace

FilmView film_view(Scene const& scene, sdpd::SimulationSettings const& settings) {
  Vec3 const edge = sdpd::box_of(settings).edge;
  std::array<int, 3> axes{2, 0, 1};
  std::ranges::stable_sort(axes, std::greater(), [&](int axis) { return component(edge, axis); });
  if (auto const& axis = scene.film.axis) // the others keep their order
    std::ranges::stable_partition(axes, [&](int one) { return one != axis->front() - 'x'; });
  OutputUnits const units(settings.units(), scene.units);
  double const middle = component(edge, axes[2]) / 2,
               half = (scene.film.thickness ? *scene.film.thickness / units.length : settings.spacing()) / 2;
  return {axes[0], axes[1], axes[2], middle - half, middle + half};
}

FilmColumn film_column(std::string const& quantity, OutputUnits const& units) {
  if (velocity_axis(quantity))
    return {quantity + units.velocity_key, units.velocity};
  auto const [unit, key] = units.of(std::ranges::find(sdpd::fields, quantity, &sdpd::Field::name)->dimension);
  return {quantity + key, unit};
}

FilmSeries::FilmSeries(Store& store, Scene const& scene, sdpd::SimulationSettings const& settings,
                       OutputUnits const& units)
    : store_(store), view_(film_view(scene, settings)), quantity_(*scene.film.quantity), units_(units),
      last_step_(workflows::last_step(store, film_group + "/step")) {}

void FilmSeries::append(sdpd::Snapshot const& now, std::int64_t step, double time) {
  if (step <= last_step_)
    return;
  auto const [name, unit] = film_column(quantity_, units_);
  auto const all = values_of(now, quantity_);
  std::vector<double> right, up, value;
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    double const depth = component(now.q[i], view_.along);
    if (depth < view_.lower || depth >= view_.upper)
      continue;
    right.push_back(component(now.q[i], view_.right) * units_.length);
    up.push_back(component(now.q[i], view_.up) * units_.length);
    value.push_back(all[i] * unit);
  }
  auto const place = [&](int axis) {
    return fmt::format("{}/{}{}", film_group, "xyz"[axis], units_.length_key);
  };
  for (auto const& [path, numbers] :
       {std::pair(place(view_.right), &right), {place(view_.up), &up}, {film_group + "/" + name, &value}})
    if (!numbers->empty())
      store_.append(path, *numbers);
  auto const frames = store_.contains(film_group + "/end") ? store_.rows(film_group + "/end") : 0;
  std::int64_t const before =
      frames > 0
          ? store_.read_integer_row(film_group + "/end", frames - 1, {.row_shape = Store::Shape{}}).at(0)
          : 0;
  std::int64_t const end = before + static_cast<std::int64_t>(right.size());
  store_.append(film_group + "/end", std::span(&end, 1));
  store_.append(film_group + "/time" + units_.time_key, std::span(&time, 1));
  store_.append(film_group + "/step", std::span(&step, 1));
  last_step_ = step;
  store_.flush();
}

} // namespace mesobridge::workflows
