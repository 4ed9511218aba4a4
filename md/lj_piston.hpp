#pragma once
#include "md/lj_fluid.hpp"
#include "md/piston_drive.hpp"

namespace mesobridge::md {

/// A Lennard-Jones fluid at rest between a piston, which moves into it along z from the time 0 on, and a wall
/// at the far end, both of which reflect atoms; periodic across. In Lennard-Jones units.
struct LjPistonSettings {
  LjState ahead{.rho = 0.6837, .T = 4.166};
  double v_P = 3.165;   ///< velocity of the piston
  int cells_across = 4; ///< of the face-centred cubic lattice that is melted, along x and y
  int cells_along = 75; ///< along z
  double cutoff = 4.0;  ///< of the potential, neither shifted nor with a tail [sigma]
  double dt = 0.002;    ///< while the piston moves
  std::int64_t melt_steps = 300, equilibration_steps = 2000; ///< of 0.01/sqrt(T*)
  std::int64_t sample_every = 40;                            ///< steps of dt
  std::uint64_t seed = 1;
  std::filesystem::path log_file = "lammps.log";

  std::int64_t atoms() const { return std::int64_t{4} * cells_across * cells_across * cells_along; }
  double length() const;  ///< of the box along z
  double spacing() const; ///< mean distance between atoms, rho^(-1/3)
  int slices() const;     ///< as many as there are spacings along z
  /// Until a front of the velocity v_S has come near the far end.
  std::int64_t steps(double v_S) const;
  /// One line for people.
  std::string description() const;
};

LjPistonSettings lj_piston_settings(Preset preset);

/// Throws InputError, naming the quantity.
void check(LjPistonSettings const& settings);

/// Melts a lattice and brings it to equilibrium as sample_lj_fluid does, lets the piston move (LAMMPS's fix
/// wall/piston) at constant energy but for its work, and tells the slices every so many steps, `steps` in
/// all. All ranks of the world run it together; the consumers of rank 0 are asked. Samples are equal for
/// equal seeds and numbers of ranks. Returns false when a consumer stopped the run. Throws as
/// sample_lj_fluid.
bool sample_lj_piston(MpiWorld const& world, LjPistonSettings const& settings, std::int64_t steps,
                      PistonConsumers const& consumers);

} // namespace mesobridge::md
