#pragma once
#include "workflows/command.hpp"
#include "workflows/trajectory/frame_blobs.hpp"

namespace mesobridge::workflows {

/// Compares the energies of a trajectory's frames with what is known about them from elsewhere: the potential
/// energy that the trajectory itself says, and that a run at constant energy keeps it.
class EnergyCheck {
 public:
  /// Whose laws tell the potential energy.
  enum class Laws {
    of_mapping, ///< those in the mapping file
    of_lammps   ///< those of LAMMPS's files that the mapping names
  };
  explicit EnergyCheck(Laws laws) : laws_(laws) {}

  /// One frame; `said` is the potential energy of the whole system by the trajectory.
  void add(std::int64_t step, FoundBlobs const& found, std::optional<double> said);

  /// What is suspicious, for people; empty if nothing is.
  std::vector<std::string> warnings() const;
  void put(Json& json) const;

 private:
  struct Row {
    std::int64_t step;
    double kinetic, potential, bonds;
    std::optional<double> said;
    double energy() const { return kinetic + potential; }
  };
  std::optional<std::string> potential_warning() const;
  std::optional<std::string> drift_warning() const;
  /// Why the potential energies of this row may differ.
  std::string guess(Row const& row) const;

  Laws laws_;
  std::vector<Row> rows_;
};

} // namespace mesobridge::workflows
