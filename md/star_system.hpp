#pragma once
#include "md/lammps_session.hpp"
#include "md/star_polymer.hpp"
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace mesobridge::md {

/// Many equal stars on a simple cubic lattice, each turned at random, in a box of which it fills all cells
/// but some at the end. LAMMPS's atom ids are molecule * atoms + 1 + number in the star.
struct StarLattice {
  StarPolymer star;
  int molecules = 1000;
  double spacing = 0; ///< [sigma], at least touching_free_spacing
  std::uint64_t seed = 1;
  std::optional<int> across = {}; ///< cells along x and y; if not given, as many as along z

  int cells() const;       ///< along x and y
  int cells_along() const; ///< along z
  double edge() const;     ///< of the box along x and y
};

/// The lattice spacing at which straight stars cannot touch, however they are turned.
double touching_free_spacing(StarPolymer const& star);

/// Makes the atoms, bonds and forces of the stars in a fresh session. `data_file` is written on the way and
/// removed. All ranks must call it.
void create_stars(MpiWorld const& world, LammpsSession& lammps, StarLattice const& lattice,
                  std::filesystem::path const& data_file);

/// Sets LAMMPS's units and styles as the stars need them; before create_stars or read_restart.
void prepare_for_stars(LammpsSession& lammps, StarPolymer const& star);

/// The forces between the beads, for a session whose atoms have just been created or read.
void set_star_forces(LammpsSession& lammps, StarPolymer const& star);

/// Does some work in LAMMPS. What an unstable run makes LAMMPS say (missing bond atoms, lost atoms) is thrown
/// as PhysicsError with the hint that follows "A shorter --dt"; `doing` names the run.
void explained(std::string const& doing, double dt, std::string const& hint,
               std::function<void()> const& work);

inline constexpr char const* shorter_step_of_stars = "keeps the bonds together; 0.001 is the thesis's";

} // namespace mesobridge::md
