#include "md/metal_crystal.hpp"
#include "md/units.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace mesobridge::md {
namespace {

/// A rectangular cell of a lattice in units of its constant.
struct Cell {
  int atoms;
  Vec3 edge;
  double nearest;     ///< distance of nearest neighbours
  Vec3 plane_spacing; ///< of planes with all atoms on them; 0: none along this axis
};

Cell cell_of(Lattice lattice) {
  double const height = std::sqrt(8.0 / 3);
  switch (lattice) {
  case Lattice::fcc:
    return {4, {1, 1, 1}, std::sqrt(0.5), {0.5, 0.5, 0.5}};
  case Lattice::bcc:
    return {2, {1, 1, 1}, std::sqrt(0.75), {0.5, 0.5, 0.5}};
  case Lattice::hcp:
    return {4, {1, std::sqrt(3.0), height}, 1, {0.5, 0, height / 2}};
  }
  throw std::logic_error("a lattice without a cell");
}

int cells_along(double cells, double edge) {
  return std::max(1, int(std::lround(cells / edge)));
}

} // namespace

CrystalBlock::CrystalBlock(Lattice lattice, int least_atoms) : lattice_(lattice) {
  require(least_atoms >= 1 && least_atoms <= 100'000'000, "atoms", least_atoms, "must be 1 ... 10^8");
  auto const cell = cell_of(lattice);
  for (int n = 1; atoms() < least_atoms; ++n) {
    nx_ = cells_along(n, cell.edge.x);
    ny_ = cells_along(n, cell.edge.y);
    nz_ = cells_along(n, cell.edge.z);
  }
}

int CrystalBlock::atoms() const {
  return cell_of(lattice_).atoms * nx_ * ny_ * nz_;
}

double CrystalBlock::lattice_constant(double number_density) const {
  auto const cell = cell_of(lattice_);
  return std::cbrt(cell.atoms / (number_density * cell.edge.x * cell.edge.y * cell.edge.z));
}

double CrystalBlock::neighbour_distance(double number_density) const {
  return cell_of(lattice_).nearest * lattice_constant(number_density);
}

Vec3 CrystalBlock::edges(double number_density) const {
  Vec3 const edge = cell_of(lattice_).edge * lattice_constant(number_density);
  return {nx_ * edge.x, ny_ * edge.y, nz_ * edge.z};
}

Vec3 CrystalBlock::plane_distances(double number_density) const {
  return cell_of(lattice_).plane_spacing * lattice_constant(number_density);
}

void CrystalBlock::create(LammpsSession& lammps, MetalPotential const& potential, double rho) const {
  lammps.command("units metal");
  lammps.command("atom_style atomic");
  lammps.command("lattice {} {}", name_of(lattice_),
                 lattice_constant(rho / potential.mass) / metal_units::length);
  lammps.command("region box block 0 {} 0 {} 0 {}", nx_, ny_, nz_);
  lammps.command("create_box 1 box");
  lammps.command("create_atoms 1 box");
  auto const fast = potential.style + "/opt";
  lammps.command("pair_style {}", lammps.has_style("pair", fast) ? fast : potential.style);
  if (potential.style == "eam")
    lammps.command_with_file("pair_coeff 1 1", potential.file);
  else
    lammps.command_with_file("pair_coeff * *", potential.file, potential.element);
  lammps.command("mass 1 {}", potential.mass / atomic_mass);
  lammps.command("neighbor 0.5 bin");
  lammps.command("neigh_modify every 2 delay 0 check yes");
}

double stated_density(MetalPotential const& potential) {
  double const constant_at_1 = CrystalBlock(potential.lattice, 1).lattice_constant(1.0);
  return potential.mass * std::pow(constant_at_1 / potential.lattice_constant, 3);
}

MetalCrystal::MetalCrystal(MpiWorld const& world, MetalPotential const& potential, Lattice lattice,
                           std::filesystem::path const& log_file, Log log)
    : potential_(potential), lattice_(lattice), block_(lattice, 30),
      lammps_(world, Ranks::own, log_file, log) {
  block_.create(lammps_, potential_, stated_density(potential_));
  lammps_.command("thermo_style custom step temp pe press pzz"); // what is printed is tallied in the step
  lammps_.command("thermo 1000000");
}

StaticState MetalCrystal::at(double rho) {
  require(rho > 0 && std::isfinite(rho), "density [kg/m^3]", rho, "must be > 0");
  return in_box(block_.edges(rho / potential_.mass), rho, "press");
}

StaticState MetalCrystal::squeezed_along_z(double rho0, double rho) {
  for (double const density : {rho0, rho})
    require(density > 0 && std::isfinite(density), "density [kg/m^3]", density, "must be > 0");
  auto edges = block_.edges(rho0 / potential_.mass);
  edges.z *= rho0 / rho;
  return in_box(edges, rho, "pzz");
}

StaticState MetalCrystal::in_box(Vec3 const& edges, double rho, char const* pressure) {
  Vec3 const edge = edges / metal_units::length;
  lammps_.command("change_box all x final 0 {} y final 0 {} z final 0 {} remap units box", edge.x, edge.y,
                  edge.z);
  lammps_.command("run 0 post no");
  double const mass = block_.atoms() * potential_.mass;
  return {rho, lammps_.thermo("pe") * metal_units::energy / mass,
          lammps_.thermo(pressure) * metal_units::pressure};
}

StaticState MetalCrystal::at_zero_pressure() {
  // Steps outwards from the stated density until the pressure has changed sign, then bisects.
  constexpr double step = 1.02;
  double const stated = stated_density(potential_);
  double low = stated, high = stated;
  while (at(low).P > 0 && low > stated / 2)
    low /= step;
  while (at(high).P < 0 && high < stated * 2)
    high *= step;
  if (at(low).P > 0 || at(high).P < 0)
    throw PhysicsError(
        fmt::format("the {} crystal of {} has no state of zero pressure between {:.0f} and {:.0f} "
                    "kg/m^3: does the lattice suit the potential?",
                    name_of(lattice_), potential_.element, low, high));
  while (high / low - 1 > 1e-12) {
    double const middle = std::sqrt(low * high);
    if (middle <= low || middle >= high)
      break;
    (at(middle).P < 0 ? low : high) = middle;
  }
  return at(std::sqrt(low * high));
}

double MetalCrystal::bulk_sound_speed(double rho) {
  constexpr double step = 1e-3;
  double const slope = (at(rho * (1 + step)).P - at(rho * (1 - step)).P) / (2 * step * rho);
  if (!(slope > 0))
    throw PhysicsError(
        fmt::format("the {} crystal of {} at {} kg/m^3 is unstable: dP/drho = {:.3g} m^2/s^2 < 0",
                    name_of(lattice_), potential_.element, rho, slope));
  return std::sqrt(slope);
}

} // namespace mesobridge::md
