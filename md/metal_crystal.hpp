#pragma once
#include "md/lammps_session.hpp"
#include "md/metal_potential.hpp"
#include <array>

namespace mesobridge::md {

/// A perfect crystal at rest.
struct StaticState {
  double rho = 0; ///< [kg/m^3]
  double e = 0;   ///< specific energy, 0 for free atoms at rest [J/kg]
  double P = 0;   ///< [Pa]
};

/// LAMMPS's metal units in SI.
namespace metal_units {
inline constexpr double length = 1e-10;
inline constexpr double energy = 1.602176634e-19; ///< 1 eV
inline constexpr double time = 1e-12;
inline constexpr double pressure = 1e5;
} // namespace metal_units

/// A block of a perfect lattice with periodic boundaries, so many cells along each edge that it is about a
/// cube. The hexagonal lattice has the ideal c/a = sqrt(8/3) and is cut into rectangular cells.
class CrystalBlock {
 public:
  /// The smallest one with at least this many atoms.
  CrystalBlock(Lattice lattice, int least_atoms);
  /// One of so many rectangular cells along x, y and z, each >= 1.
  CrystalBlock(Lattice lattice, std::array<int, 3> const& cells)
      : lattice_(lattice), nx_(cells[0]), ny_(cells[1]), nz_(cells[2]) {}

  int atoms() const;
  /// Edge of the lattice's cubic cell, or a of the hexagonal one, at a number density [1/m^3]; in metres.
  double lattice_constant(double number_density) const;
  /// Distance of nearest neighbours [m].
  double neighbour_distance(double number_density) const;
  Vec3 edges(double number_density) const; ///< [m]
  /// Distances of planes of atoms along the box's axes whose Bragg reflection the crystal shows, as
  /// `lattice_order` wants them; 0 where no such plane is used [m].
  Vec3 plane_distances(double number_density) const;

  /// Defines box, atoms and potential in a new session.
  void create(LammpsSession& lammps, MetalPotential const& potential, double rho) const;

 private:
  Lattice lattice_;
  int nx_ = 1, ny_ = 1, nz_ = 1;
};

/// Density of the lattice that the potential file states, with the constant that it states [kg/m^3].
double stated_density(MetalPotential const& potential);

/// The perfect crystal of a potential, whose states LAMMPS computes without any motion.
class MetalCrystal {
 public:
  MetalCrystal(MpiWorld const& world, MetalPotential const& potential, Lattice lattice,
               std::filesystem::path const& log_file, Log log = Log::replace);

  /// Throws InputError for a density that is not > 0 and finite, LammpsError.
  StaticState at(double rho);
  /// The crystal of the density rho0 that has been squeezed along z alone to the density rho; P is P_zz. Its
  /// lattice is another: fcc becomes bcc where rho = sqrt(2) rho0 (md/README.md, Eq. (M15)).
  StaticState squeezed_along_z(double rho0, double rho);
  /// The state of zero pressure nearest to the stated density. Throws PhysicsError when there is none between
  /// half and twice of it.
  StaticState at_zero_pressure();
  /// sqrt(dP/drho) at rest [m/s]. Throws PhysicsError where the lattice is unstable against a change of
  /// volume.
  double bulk_sound_speed(double rho);

 private:
  /// In a box of these edges [m]; `pressure` is LAMMPS's name of the one that is asked for.
  StaticState in_box(Vec3 const& edges, double rho, char const* pressure);

  MetalPotential potential_;
  Lattice lattice_;
  CrystalBlock block_;
  LammpsSession lammps_;
};

} // namespace mesobridge::md
