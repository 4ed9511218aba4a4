#pragma once
#include "cg/blobs.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Compares the energies of a trajectory's frames with what is known about them from elsewhere: the potential
/// energy that the trajectory itself says, and that a run at constant energy keeps it.
class EnergyCheck {
 public:
  explicit EnergyCheck(cg::MoleculeModel const& model) : model_(model) {}

  /// One frame; `said` is the potential energy of the whole system by the trajectory, `bonds` that of the
  /// mapping's bonds alone.
  void add(cg::BlobFrame const& frame, std::optional<double> said, double bonds);

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

  cg::MoleculeModel const& model_;
  std::vector<Row> rows_;
};

/// The energy of the bonds of all molecules, whose joined shapes nearest images along the bonds tell.
double bond_energy(cg::MoleculeModel const& model, std::span<Vec3 const> q, Box const& box);

} // namespace mesobridge::workflows
