#pragma once
#include "md/lammps_session.hpp"
#include "md/lj_fluid.hpp"
#include <optional>

namespace mesobridge::md {

/// The same of the centres of mass of molecules: how many there are, their velocity along z, and the
/// temperature of their motion across (md/README.md, Eq. (M14)).
struct MoleculeSlices {
  std::vector<double> number, velocity, T;
};

/// Means over the atoms of slices of equal width along z, at one instant (md/README.md, Eq. (M10)). A slice
/// without atoms holds 0, as has P with a single one.
struct PistonSlices {
  std::int64_t step = 0;
  double time = 0, piston = 0;  ///< since the piston began to move, and where it is
  std::vector<double> number;   ///< of atoms
  std::vector<double> velocity; ///< along z
  std::vector<double> T;        ///< of the motion across: along z the fluid flows
  std::vector<double> P;        ///< P_zz: the motion about the mean velocity and the virial, without a tail
  double energy = 0;            ///< of all atoms, kinetic and potential
  MoleculeSlices molecules;     ///< empty where atoms are not bound
};

struct PistonConsumers {
  std::function<bool(PistonSlices const&)> slices; ///< false stops the run at once
  StepConsumer steps;                              ///< of all, those to equilibrium among them
};

/// A box along z between a piston at its lower face and a wall at the upper one, in the units of its LAMMPS.
struct PistonBox {
  double length, area; ///< along z, and across
  double v_P, dt;
  int slices;
  std::int64_t sample_every;  ///< steps
  int atoms_per_molecule = 0; ///< ids of its atoms follow each other; 0: atoms are not bound
  /// Where it is given, the run is over when the slices from there to the far end move at v_P/2.
  std::optional<double> end;
};

/// What LAMMPS's units make of an atom of one kind: k_B T = energy_of_mv2 m v^2 of one component, and
/// pressures are pressure_of_energy times energies per volume.
struct PistonUnits {
  double mass = 1, energy_of_mv2 = 1, pressure_of_energy = 1, boltzmann = 1;
};

/// Steps of dt until a front of the velocity v_S has come from the piston to 8 spacings before the far end of
/// a box of that length, all in one set of units.
std::int64_t steps_to_far_end(double length, double spacing, double v_S, double dt);

/// Atoms at rest that are given a piston: walls in place of the periodicity along z, and the slices. All
/// ranks of the world call it together; the consumers of rank 0 are asked.
class PistonDrive {
 public:
  PistonDrive(MpiWorld const& world, LammpsSession& lammps, PistonBox const& box, PistonUnits const& units,
              PistonConsumers const& consumers)
      : world_(world), lammps_(lammps), box_(box), units_(units), consumers_(consumers) {}

  /// Runs on before the piston moves, in short pieces of what LAMMPS is told to be one run. False when a
  /// consumer stopped it.
  bool settle(std::int64_t steps);

  /// Ends the periodicity along z and the time so far; every atom has its thermal velocity.
  void put_walls();

  /// Lets the piston move for so many steps, or until the front is at the end of the box. False when a
  /// consumer stopped it. Throws PhysicsError that begins with `what` when the motion becomes unstable.
  bool drive(std::int64_t steps, std::string const& what);

 private:
  void declare_slices();
  std::vector<double> sum(std::string const& name);
  PistonSlices slices_at(std::int64_t step, std::string const& what);
  MoleculeSlices molecules_at();
  bool has_arrived(PistonSlices const& slices) const;
  bool told(std::int64_t steps);
  template <class Question>
  bool asked(Question const& question);

  MpiWorld const& world_;
  LammpsSession& lammps_;
  PistonBox box_;
  PistonUnits units_;
  PistonConsumers const& consumers_;
  std::int64_t steps_done_ = 0;
};

} // namespace mesobridge::md
