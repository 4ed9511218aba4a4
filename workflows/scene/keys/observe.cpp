#include "sdpd/observe/list.hpp"
#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include "workflows/scene/quantities.hpp"
#include <fmt/ranges.h>

namespace mesobridge::workflows {
namespace {

bool asks_for_series(Scene const& scene) {
  return scene.series != Scene::Series{};
}

bool asks_for_film(Scene const& scene) {
  return scene.film != Scene::Film{};
}

/// "name (what it is; components; passes over all pairs)" for each measurement that may be asked for.
std::string series_text() {
  std::vector<std::string> texts;
  for (auto const& measured : sdpd::measurements()) {
    if (measured.in_every_run())
      continue;
    std::vector<std::string> parts{std::string(measured.meaning)};
    if (measured.components.size() > 1)
      parts.push_back(fmt::format("{} components", measured.components.size()));
    if (measured.pair_passes > 0)
      parts.push_back(measured.pair_passes == 1 ? "costs a pass over all pairs"
                                                : fmt::format("costs {} passes", measured.pair_passes));
    if (measured.by_name_only)
      parts.emplace_back("to be named");
    texts.push_back(fmt::format("{} ({})", measured.name, fmt::join(parts, "; ")));
  }
  return fmt::format("of the whole fluid, beside what every sample holds: {}. []: all that the method has "
                     "but those to be named",
                     fmt::join(texts, ", "));
}

} // namespace

std::vector<SceneKey> observe_keys() {
  Table const profile{"profile", &Scene::profile};
  Table const histogram{"histogram", &Scene::histogram};
  Table const film{"film", &Scene::film};
  return {
      profile("axis", &Scene::Profile::axis, "direction of the profile: its slices are perpendicular to it")
          .choices({"x", "y", "z"}),
      profile("bins", &Scene::Profile::bins, "slices of equal width").in({.min = 1, .max = 1e6}),
      profile("every", &Scene::Profile::every,
              "steps between profiles, of one instant each, under `profile` of run.h5; 0: none")
          .in(not_negative),
      profile(
          "quantities", &Scene::Profile::quantities,
          "means over the particles of a slice: rho (dpde, dpd: mass per volume), velocity, T_kin (of the "
          "motion about that velocity), T_int (not dpd), P_internal (of the particles' own pressures, sdpd), "
          "P (with what the moving particles carry; dpde, dpd: by their virials). []: all that the method "
          "has")
          .choices(names_of(profile_quantities())),
      histogram("bins", &Scene::Histogram::bins, "of equal width").in({.min = 1, .max = 1e6}),
      histogram(
          "every", &Scene::Histogram::every,
          "steps between histograms over all particles, of one instant each, under `histogram` of run.h5; 0: "
          "none")
          .in(not_negative),
      histogram(
          "reach", &Scene::Histogram::reach,
          "bins reach from the mean of the first histogram's particles so many of their standard deviations "
          "either "
          "way; what lies beyond is counted as well")
          .in({.min = 0, .open = true, .max = 1e6}),
      histogram("quantities", &Scene::Histogram::quantities,
                "of the particles: eps and T (not dpd), rho and P (sdpd). []: all that the method has")
          .choices(names_of(histogram_quantities())),
      Line(
          "series", "every", [](Scene& s) { return &s.series.every; },
          "steps between measurements of the quantities, under `series` of run.h5, with means in summary and "
          "report; 0: none")
          .in(not_negative)
          .written_if(asks_for_series),
      Line(
          "series", "quantities", [](Scene& s) { return &s.series.quantities; }, series_text())
          .choices(names_of(series_quantities()))
          .written_if(asks_for_series),
      film("quantity", &Scene::Film::quantity,
           "a film of the particles of a slab, coloured by T, eps (not dpd), rho, P (sdpd), progress "
           "(reactions) or a component of their velocity: under `film` of run.h5, as a strip in the report, "
           "and as pictures (run --frames). "
           "If not given, there is none")
          .choices(names_of(film_quantities()))
          .written_if(asks_for_film),
      film("every", &Scene::Film::every, "steps between its frames; 0: a fifth of run.steps, which makes six")
          .in(not_negative)
          .written_if(asks_for_film),
      film("axis", &Scene::Film::axis,
           "along which one looks; if not given, along the shortest edge of the box")
          .choices({"x", "y", "z"})
          .written_if(asks_for_film),
      film("thickness", &Scene::Film::thickness,
           "of the slab, in the middle of the box; if not given, the mean distance between particles")
          .quantity(Dimension::length, positive)
          .written_if(asks_for_film),
  };
}

} // namespace mesobridge::workflows
