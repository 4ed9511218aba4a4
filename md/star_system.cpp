#include "md/star_system.hpp"
#include "md/molecule_atoms.hpp"
#include "md/seeds.hpp"
#include <cmath>
#include <fmt/os.h>

namespace mesobridge::md {
namespace {

/// Bonds longer than this are not found across the borders of ranks. At k = 20 one costs 35 epsilon.
constexpr double longest_bond = 3.5;
constexpr double skin = 0.45;

double uniform(std::uint64_t seed, std::uint64_t molecule, std::uint64_t which) {
  return double(mix(mix(seed, molecule), which) >> 11) * 0x1p-53;
}

void write_data_file(StarLattice const& lattice, std::filesystem::path const& file) {
  auto const bonds = lattice.star.bonds();
  int const n = lattice.star.atoms(), cells = lattice.cells();
  auto const straight = straight_star(lattice.star);
  auto out = fmt::output_file(file.string());
  out.print("stars\n\n{} atoms\n{} bonds\n1 atom types\n2 bond types\n", lattice.molecules * n,
            std::size_t(lattice.molecules) * bonds.size());
  out.print("0 {0} xlo xhi\n0 {0} ylo yhi\n0 {1} zlo zhi\n\nMasses\n\n1 1\n\nAtoms # bond\n\n",
            lattice.edge(), lattice.cells_along() * lattice.spacing);
  for (int m = 0; m < lattice.molecules; ++m) {
    Vec3 const centre = lattice.spacing * Vec3{m % cells + 0.5, (m / cells) % cells + 0.5,
                                               std::floor(double(m) / cells / cells) + 0.5};
    auto const key = std::uint64_t(m);
    auto const atoms = turned(straight, uniform(lattice.seed, key, 0), uniform(lattice.seed, key, 1),
                              uniform(lattice.seed, key, 2));
    for (int i = 0; i < n; ++i) {
      Vec3 const q = centre + atoms[std::size_t(i)];
      out.print("{} {} 1 {} {} {}\n", m * n + i + 1, m + 1, q.x, q.y, q.z);
    }
  }
  out.print("\nBonds\n\n");
  std::size_t bond_id = 0;
  for (int m = 0; m < lattice.molecules; ++m)
    for (auto const& bond : bonds)
      out.print("{} {} {} {}\n", ++bond_id, bond.a == 0 ? 1 : 2, m * n + bond.a + 1, m * n + bond.b + 1);
}

bool tells_of_instability(std::string_view text) {
  for (std::string_view sign : {"Bond atom", "Angle atom", "Dihedral atom", "Improper atom", "Lost atoms",
                                "Out of range atoms", "Non-numeric", "Bond extent", "Angle extent",
                                "Dihedral/improper extent", "Bad FENE bond", "Atom count is inconsistent"})
    if (text.find(sign) != std::string_view::npos)
      return true;
  return false;
}

} // namespace

int StarLattice::cells() const {
  return across.value_or(int(std::ceil(std::cbrt(molecules) - 1e-9)));
}

int StarLattice::cells_along() const {
  int const layer = cells() * cells();
  return across ? (molecules + layer - 1) / layer : cells();
}

double StarLattice::edge() const {
  return cells() * spacing;
}

double touching_free_spacing(StarPolymer const& star) {
  return 2 * straight_radius(star) + wca_cutoff();
}

void prepare_for_stars(LammpsSession& lammps, StarPolymer const&) {
  lammps.command("units lj");
  lammps.command("atom_style bond");
  lammps.command("atom_modify map array");
  lammps.command("comm_modify cutoff {}", longest_bond);
}

void set_star_forces(LammpsSession& lammps, StarPolymer const& star) {
  lammps.command("special_bonds lj 1 1 1");
  if (star.repulsion) {
    // LAMMPS's lj/cut/opt is slower where atoms have so few neighbours: 2.5 against 2.0 s for 3000 steps of
    // 160 6-12 stars at rho = 0.5.
    lammps.command("pair_style lj/cut {}", wca_cutoff());
    lammps.command("pair_modify shift yes");
    lammps.command("pair_coeff 1 1 1 1 {}", wca_cutoff());
  }
  lammps.command("bond_style harmonic");
  lammps.command("bond_coeff 1 {} {}", star.k / 2, star.centre_length); // LAMMPS's K is k/2
  lammps.command("bond_coeff 2 {} {}", star.k / 2, star.arm_length);
  lammps.command("neighbor {} bin", skin);
  lammps.command("neigh_modify every 5 delay 5 check yes");
  tally_atom_energies(lammps);
}

void create_stars(MpiWorld const& world, LammpsSession& lammps, StarLattice const& lattice,
                  std::filesystem::path const& data_file) {
  double const narrowest = touching_free_spacing(lattice.star);
  require(lattice.spacing >= narrowest, "spacing of the stars at the start", lattice.spacing,
          fmt::format("straight {} stars would overlap: it must be at least {:.4g}", lattice.star.name(),
                      narrowest));
  if (world.is_root())
    write_data_file(lattice, data_file);
  world.barrier();
  lammps.command_with_file("read_data", data_file);
  world.barrier();
  if (world.is_root())
    std::filesystem::remove(data_file);
}

void explained(std::string const& doing, double dt, std::string const& hint,
               std::function<void()> const& work) {
  try {
    work();
  } catch (LammpsError const& error) {
    if (!tells_of_instability(error.what()))
      throw;
    throw PhysicsError(fmt::format("{} became unstable at the time step {}: {}. A shorter --dt {}", doing, dt,
                                   error.what(), hint));
  }
}

} // namespace mesobridge::md
