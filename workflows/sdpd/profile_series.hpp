#pragma once
#include "sdpd/observe/profile.hpp"
#include "sdpd/state/snapshot.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// The profiles of a run, under `profile` of its file: `step`, the time, the slices' centres, the number of
/// particles in each slice and the quantities that the scene asks for, each a dataset with one row a profile,
/// named with its unit (`rho_kg_m3`). A slice without particles has the number 0 and means that are 0; T_kin
/// takes two. A resumed run repeats its steps: rows that the file holds already are skipped.
class ProfileSeries {
 public:
  /// Goes on after the rows that the file holds. The store must outlive the series.
  ProfileSeries(Store& store, Scene const& scene, OutputUnits const& units, double boltzmann);

  bool shows(std::string const& quantity) const;

  /// `time` is in the scene's units. The rows are flushed.
  void append(sdpd::Snapshot const& now, Box const& box, std::int64_t step, double time);

 private:
  void describe(Box const& box);
  void append(std::string const& quantity, sdpd::Profile const& profile);

  Store& store_;
  sdpd::Slices slices_;
  std::string axis_;
  std::vector<std::string> quantities_;
  OutputUnits units_;
  double boltzmann_;
  std::int64_t last_step_ = -1;
};

} // namespace mesobridge::workflows
