#pragma once
#include "cg/estimate.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/sdpd/measured_columns.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// The measurements that a scene asks for, under `series` of its run's file: `step`, the time and, for each
/// of them, a dataset named with its unit (`pressure_tensor_Pa`) that has one row a time, with the components
/// that its attribute `components` names. A resumed run repeats its steps: rows that the file holds already
/// are skipped.
class MeasuredSeries {
 public:
  /// Goes on after the rows that the file holds. The store must outlive the series. Throws InputError when
  /// the file holds other measurements than the scene's.
  MeasuredSeries(Store& store, Scene const& scene, OutputUnits const& units);

  /// Measures; `time` is in the scene's units. The rows are flushed. Throws PhysicsError for what is no
  /// number.
  void append(sdpd::Simulation const& simulation, std::int64_t step, double time);

 private:
  Store& store_;
  std::vector<sdpd::Measurement> measured_;
  OutputUnits units_;
  std::int64_t last_step_ = -1;
};

/// The measurements that a scene asks for.
std::vector<sdpd::Measurement> measured_in_series(Scene const& scene);

/// Throws InputError for one that the scene's box does not allow.
void check_series(Scene const& scene);

/// One component of a measurement: its row for every time, in the scene's units.
struct MeasuredComponent {
  sdpd::Measurement of;
  std::size_t component;
  std::vector<double> values;
  cg::Estimate mean() const;
};

/// What a run's file holds of the measurements that the scene asks for, component by component in the order
/// of the scene; empty when it asks for none or none was due. Throws InputError for a damaged file.
std::vector<MeasuredComponent> measured_components(Store const& store, Scene const& scene,
                                                   OutputUnits const& units);
/// The times of these rows, in the scene's units.
std::vector<double> measured_times(Store const& store, OutputUnits const& units);

} // namespace mesobridge::workflows
