#pragma once
#include "md/piston_drive.hpp"
#include "md/star_polymer.hpp"

namespace mesobridge::md {

/// A melt of stars at rest between a piston, which moves into it along z from the time 0 on, and a wall at
/// the far end, both of which reflect beads; periodic across. In Lennard-Jones units.
struct StarPistonSettings {
  StarPolymer star;
  double rho = 0.3;     ///< beads per sigma^3 of the whole box, (0, 0.7]
  double T = 1;         ///< of the thermostat that the melt at rest has had
  double v_P = 0.5;     ///< velocity of the piston
  int across = 5;       ///< molecules along x and y
  int along = 120;      ///< along z
  double friction = 1;  ///< of the thermostat [1/time]
  double dt = 0.004;    ///< time step
  double squeeze = 1.3; ///< the density changes by at most this factor at once
  std::int64_t squeeze_steps = 1000, equilibration_steps = 20000;
  std::int64_t sample_every = 50; ///< steps
  std::uint64_t seed = 1;
  std::filesystem::path log_file = "lammps.log"; ///< in a folder that gets the start's file, too

  std::int64_t molecules() const { return std::int64_t{across} * across * along; }
  std::int64_t atoms() const { return molecules() * star.atoms(); }
  double spacing() const; ///< mean distance between molecules
  double length() const;  ///< of the box along z
  int slices() const { return along; }
  std::int64_t steps_before() const; ///< the piston moves
  /// Until a front of the velocity v_S has come near the far end.
  std::int64_t steps(double v_S) const;
  /// One line for people.
  std::string description() const;
};

StarPistonSettings star_piston_settings(Preset preset);

/// Throws InputError, naming the quantity.
void check(StarPistonSettings const& settings);

/// Squeezes stars from a dilute lattice to their density between walls, which are there from the first step
/// so that no bond crosses them, brings them to equilibrium under Langevin's thermostat, lets the piston move
/// (LAMMPS's fix wall/piston) at constant energy but for its work, and tells the slices every so many steps,
/// of the molecules too (md/README.md, Eqs. (M10), (M14)). It ends after `steps`, or before when the front
/// has come near the far end. All ranks of the world run it together; the consumers of rank 0 are asked.
/// Returns false when a consumer stopped the run. Throws InputError as `check`, LammpsError, and PhysicsError
/// when the run becomes unstable.
bool sample_star_piston(MpiWorld const& world, StarPistonSettings const& settings, std::int64_t steps,
                        PistonConsumers const& consumers);

} // namespace mesobridge::md
