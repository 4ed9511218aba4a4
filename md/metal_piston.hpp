#pragma once
#include "md/metal.hpp"
#include "md/piston_drive.hpp"

namespace mesobridge::md {

/// A crystal at rest between a piston, which moves into it along the z axis of its cubic cell from the time 0
/// on, and a wall at the far end, both of which reflect atoms; periodic across. In SI but where it says
/// otherwise.
struct MetalPistonSettings {
  MetalPotential potential;
  Lattice lattice = Lattice::fcc;          ///< fcc or bcc
  MetalState ahead;                        ///< density and temperature of the crystal at rest
  double v_P = 1500;                       ///< velocity of the piston [m/s]
  int cells_across = 6;                    ///< cubic cells along x and y
  int cells_along = 100;                   ///< along z
  double dt = 1e-15;                       ///< time step [s]
  std::int64_t equilibration_steps = 1000; ///< at T, all faces periodic
  std::int64_t sample_every = 20;          ///< steps
  std::uint64_t seed = 1;
  std::filesystem::path log_file = "lammps.log";

  CrystalBlock block() const { return {lattice, {cells_across, cells_across, cells_along}}; }
  std::int64_t atoms() const { return block().atoms(); }
  double length() const;  ///< of the box along z [m]
  double spacing() const; ///< (mass per atom / density)^(1/3) [m]
  /// One a cubic cell: a slice of another width would hold one plane of atoms here and two there.
  int slices() const { return cells_along; }
  /// Until a front of the velocity v_S [m/s] has come near the far end.
  std::int64_t steps(double v_S) const;
  /// One line for people.
  std::string description() const;
};

/// Settings for a crystal in that state, with a time step for its shocked atoms: half of that of equilibrium
/// runs (MetalSettings), where they meet at the speed of sound or the piston's; LAMMPS, which is asked for
/// the former, writes to the log file. Throws InputError, LammpsError, PhysicsError.
MetalPistonSettings metal_piston_settings(Preset preset, MetalPotential const& potential, Lattice lattice,
                                          MetalState ahead, double v_P,
                                          std::filesystem::path const& log_file);

/// Throws InputError, naming the quantity.
void check(MetalPistonSettings const& settings);

/// Brings the crystal to equilibrium under Langevin's thermostat, lets the piston move (LAMMPS's fix
/// wall/piston) at constant energy but for its work, and tells the slices every so many steps, in LAMMPS's
/// metal units (metal_units: velocities in Angstrom/ps, pressures in bar). All ranks of the world run it
/// together; the consumers of rank 0 are asked. Returns false when a consumer stopped the run. Throws
/// InputError as `check`, LammpsError, PhysicsError when the run becomes unstable.
bool sample_metal_piston(MpiWorld const& world, MetalPistonSettings const& settings, std::int64_t steps,
                         PistonConsumers const& consumers);

} // namespace mesobridge::md
