#pragma once
#include "md/box.hpp"
#include "sdpd/state/snapshot.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// How one looks at a film's particles: which axes go to the right and up, and the slab that is seen.
struct FilmView {
  int right, up, along; ///< 0, 1, 2; the longest edge of the box goes to the right
  double lower, upper;  ///< the slab's places along `along`, reduced
};
FilmView film_view(Scene const& scene, sdpd::SimulationSettings const& settings);

/// The film of a run, under `film` of its file: `step` and the time of each frame, `end`, the number of
/// points up to its end, and of each point its place to the right and up and its quantity, named with their
/// units
/// (`z_m`, `x_m`, `T_K`). A resumed run repeats its steps: frames that the file holds already are skipped.
class FilmSeries {
 public:
  /// Goes on after the frames that the file holds. The store must outlive the series.
  FilmSeries(Store& store, Scene const& scene, sdpd::SimulationSettings const& settings,
             OutputUnits const& units);

  /// `time` is in the scene's units. The frame is flushed.
  void append(sdpd::Snapshot const& now, std::int64_t step, double time);

 private:
  Store& store_;
  FilmView view_;
  std::string quantity_;
  OutputUnits units_;
  std::int64_t last_step_;
};

/// The quantity's column in the file: the name with its unit, and the factor from reduced units.
struct FilmColumn {
  std::string name;
  double unit;
};
FilmColumn film_column(std::string const& quantity, OutputUnits const& units);

} // namespace mesobridge::workflows
