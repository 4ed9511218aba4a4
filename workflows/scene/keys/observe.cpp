#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include "workflows/scene/quantities.hpp"

namespace mesobridge::workflows {

std::vector<SceneKey> observe_keys() {
  Table const profile{"profile", &Scene::profile};
  Table const histogram{"histogram", &Scene::histogram};
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
  };
}

} // namespace mesobridge::workflows
