#pragma once
#include "sdpd/state/snapshot.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// Histograms over all particles of a run, under `histogram` of its file: `step`, the time and, for each
/// quantity that the scene asks for, a group named with its unit (`eps_J`) that holds the bins' `edges` and,
/// one row a histogram, the particles' `counts`, and how many lie `below` and `above` the bins. The bins are
/// those of the first histogram, its mean and `reach` standard deviations either way; of a field between two
/// bounds they lie between these. A resumed run repeats its steps: rows that the file holds already are
/// skipped.
class HistogramSeries {
 public:
  /// Goes on after the rows that the file holds. The store must outlive the series.
  HistogramSeries(Store& store, Scene const& scene, OutputUnits const& units);

  /// `time` is in the scene's units. The rows are flushed. Throws PhysicsError when all particles are alike
  /// at the first histogram: bins would have no width.
  void append(sdpd::Snapshot const& now, std::int64_t step, double time);

 private:
  struct Bins {
    double lower, upper; ///< reduced
  };
  struct Quantity {
    std::string group;
    std::vector<double> const& values; ///< reduced
    double unit;
    NumberRange range; ///< of the values that make sense
  };
  Quantity find(std::string const& name, sdpd::Snapshot const& now) const;
  Bins bins_of(Quantity const& quantity);

  Store& store_;
  std::size_t bins_;
  double reach_;
  std::vector<std::string> quantities_;
  OutputUnits units_;
  std::int64_t last_step_ = -1;
};

} // namespace mesobridge::workflows
