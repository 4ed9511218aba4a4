#include "md/molecule_atoms.hpp"

namespace mesobridge::md {
namespace {

/// What travels for each atom: id, q, v, f, potential.
constexpr std::size_t numbers_of_atom = 11;

/// The first molecule of a rank's share; that of the rank after the last is their number.
int first_of(int rank, int ranks, int molecules) {
  return int((std::int64_t{molecules} * rank + ranks - 1) / ranks);
}

int rank_of(int molecule, int ranks, int molecules) {
  return int(std::int64_t{molecule} * ranks / molecules);
}

std::vector<std::vector<double>> parcels(OwnedAtoms const& atoms, int ranks, int molecules,
                                         int atoms_per_molecule) {
  std::vector<std::vector<double>> to_each(std::size_t(ranks), std::vector<double>{});
  for (std::size_t i = 0; i < atoms.ids.size(); ++i) {
    int const molecule = int((atoms.ids[i] - 1) / atoms_per_molecule);
    auto& parcel = to_each[std::size_t(rank_of(molecule, ranks, molecules))];
    Vec3 const &q = atoms.q[i], &v = atoms.v[i], &f = atoms.f[i];
    parcel.insert(parcel.end(),
                  {double(atoms.ids[i]), q.x, q.y, q.z, v.x, v.y, v.z, f.x, f.y, f.z, atoms.potential[i]});
  }
  return to_each;
}

void unpack(std::vector<double> const& numbers, MoleculeFrame& frame) {
  auto const n = std::size_t(frame.molecules) * std::size_t(frame.atoms_per_molecule);
  frame.q.resize(n), frame.v.resize(n), frame.f.resize(n), frame.potential.resize(n);
  if (numbers.size() != n * numbers_of_atom)
    throw PhysicsError(fmt::format("{} atoms were lost by step {}: the time step is too long, or the start "
                                   "has overlapping atoms",
                                   n - numbers.size() / numbers_of_atom, frame.step));
  std::int64_t const first_id = std::int64_t{frame.first_molecule} * frame.atoms_per_molecule + 1;
  for (auto record = numbers.begin(); record != numbers.end(); record += numbers_of_atom) {
    auto const i = std::size_t(std::int64_t(record[0]) - first_id);
    frame.q[i] = {record[1], record[2], record[3]};
    frame.v[i] = {record[4], record[5], record[6]};
    frame.f[i] = {record[7], record[8], record[9]};
    frame.potential[i] = record[10];
  }
}

} // namespace

void tally_atom_energies(LammpsSession& lammps) {
  lammps.command("compute {} all pe/atom", atom_energy_compute);
  lammps.command("compute {0}_sum all reduce sum c_{0}", atom_energy_compute);
  lammps.command("thermo_style custom step temp etotal pe ke press vol c_{}_sum", atom_energy_compute);
  lammps.command("thermo_modify norm no");
}

MoleculeFrame collect_molecules(MpiWorld const& world, LammpsSession& lammps, int molecules,
                                int atoms_per_molecule) {
  int const first = first_of(world.rank(), world.size(), molecules);
  MoleculeFrame frame{
      .step = lammps.step(),
      .time =
          double(lammps.step()) * lammps.thermo("dt"), // LAMMPS's own time begins anew with each checkpoint
      .box = {{lammps.thermo("lx"), lammps.thermo("ly"), lammps.thermo("lz")}},
      .energy = lammps.thermo("etotal"),
      .pressure = lammps.thermo("press") / lammps.unit_constants().pressure_of_nkt,
      .first_molecule = first,
      .molecules = first_of(world.rank() + 1, world.size(), molecules) - first,
      .atoms_per_molecule = atoms_per_molecule,
      .q = {},
      .v = {},
      .f = {},
      .potential = {},
      .inside = {},
  };
  auto const atoms = lammps.owned_atoms(atom_energy_compute);
  unpack(world.exchange(parcels(atoms, world.size(), molecules, atoms_per_molecule)), frame);
  return frame;
}

} // namespace mesobridge::md
