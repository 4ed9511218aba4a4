#pragma once
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/state/snapshot.hpp"
#include "workflows/provenance.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/store/store.hpp"
#include <optional>

namespace mesobridge::workflows {

/// The HDF5 file of one run: `thermodynamics` (one row a sample), `moments` (one row an instant) and,
/// under `particles`, internal energies, densities and pressures of the first particles at those instants; of
/// all that, what the method has.
/// The attribute `columns` names the columns with their units. Rows are flushed as they come, so that a
/// stopped run keeps them.
///
/// A resumed run repeats the steps after its checkpoint bit for bit: rows that the file holds already are
/// skipped, and those that a run which was killed wrote after its last mark() are gone.
class RunFile {
 public:
  RunFile(std::filesystem::path const& file, OutputUnits const& units, sdpd::Features features,
          Provenance const& provenance);
  static RunFile continue_file(std::filesystem::path const& file, OutputUnits const& units,
                               sdpd::Features features);

  /// The columns of `thermodynamics`, in their order.
  static std::vector<std::string> column_names(OutputUnits const& units, sdpd::Features features);

  /// Throws InputError when the last rows are older than those of these steps (see workflows::refuse_gap).
  void refuse_gap(std::int64_t last_sample, std::int64_t last_instant) const;

  /// Steps and times count from the begin of the sampling.
  void append(sdpd::Observation now, std::int64_t step, double time);
  void append(sdpd::Snapshot const& now, sdpd::InstantMoments const& moments, std::int64_t step);

  /// All samples of the file, in reduced units.
  sdpd::EquilibriumSampler replay() const;

  /// All stored values of "eps", "rho" or "P" of single particles, in the scene's units; none where there are
  /// none.
  std::vector<double> particle_values(std::string const& name) const;

  /// One column of `thermodynamics`, in the scene's units; empty if there is no such column.
  std::vector<double> column(std::string const& name) const;
  /// Its mean; nothing if there is no such column.
  std::optional<cg::Estimate> mean(std::string const& column_name) const;

  /// What is in the file now is safe, whatever happens to the program. Throws EnvironmentError.
  void mark() { store_.mark(); }

  std::filesystem::path const& file() const { return store_.file(); }

  /// For further series of the same run.
  Store& store() { return store_; }
  Store const& store() const { return store_; }

  void close() { store_.close(); }

  /// At most this many particles are stored at an instant: enough for a distribution.
  static constexpr std::size_t stored_particles = 5000;

 private:
  RunFile(Store store, OutputUnits const& units, sdpd::Features features)
      : store_(std::move(store)), units_(units), features_(features) {}

  /// One column of `thermodynamics`.
  struct Column {
    std::string name;
    double value; ///< in the scene's units
  };
  static std::vector<Column> columns(OutputUnits const& units, sdpd::Features features,
                                     sdpd::Observation const& now, double time);
  std::vector<Column> columns(sdpd::Observation const& now, double time) const {
    return columns(units_, features_, now, time);
  }

  Store store_;
  OutputUnits units_;
  sdpd::Features features_;
  std::int64_t last_row_ = -1, last_instant_ = -1; ///< steps of the last rows
};

} // namespace mesobridge::workflows
