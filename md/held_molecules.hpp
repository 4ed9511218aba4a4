#pragma once
#include "md/molecule_atoms.hpp"
#include <span>
#include <vector>

namespace mesobridge::md {

/// Holds the centres of mass of equal molecules where they are (md/README.md, Eq. (M11)): their momenta are
/// taken away once, the net forces on them at every step. Atom ids are molecule * atoms + 1 + number in the
/// molecule. The ranks of the session make all calls together.
class HeldMolecules {
 public:
  /// `masses` are those of a molecule's atoms, in order. The session must outlive no call of this object.
  HeldMolecules(MpiWorld const& world, LammpsSession& lammps, int molecules, std::vector<double> masses);

  /// Takes the momentum of each molecule from its atoms' velocities.
  void stop();
  /// Scales the velocities so that the motion about the centres has exactly the temperature T > 0.
  void set_temperature(double T);
  /// Takes the net forces away from here on.
  void hold();

  /// Puts the net forces of the step that a frame was taken at back on its atoms. Throws PhysicsError when a
  /// molecule has gained momentum beyond round-off.
  void put_back(MoleculeFrame& frame) const;

 private:
  std::size_t molecule_of(std::int64_t id) const { return std::size_t(id - 1) / masses_.size(); }
  std::size_t atom_of(std::int64_t id) const { return std::size_t(id - 1) % masses_.size(); }
  void take_away(ForcedAtoms const& atoms);

  MpiWorld const& world_;
  LammpsSession& lammps_;
  std::vector<double> masses_;
  double mass_;
  std::vector<double> net_; ///< force on each molecule as of the last step, three numbers each
};

} // namespace mesobridge::md
