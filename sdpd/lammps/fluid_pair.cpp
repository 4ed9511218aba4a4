#define OMPI_SKIP_MPICXX 1
#include "sdpd/lammps/fluid_pair.hpp"

namespace mesobridge::sdpd {
namespace {

FluidReader reader = nullptr;

} // namespace

void set_fluid_reader(FluidReader of) {
  reader = of;
}

SimulationSettings read_fluid(std::vector<std::string> const& words) {
  if (!reader)
    throw InputError("nobody here reads the words behind pair_style mesobridge");
  return reader(words);
}

LAMMPS_NS::Pair* make_fluid_pair(LAMMPS_NS::LAMMPS* lammps) {
  return new FluidPair(lammps); // LAMMPS deletes it
}

RankParticles particles_of(LAMMPS_NS::LAMMPS const& lammps) {
  auto const& atom = *lammps.atom;
  auto const owned = static_cast<std::size_t>(atom.nlocal);
  auto rows = [](double** of) { return of ? of[0] : nullptr; };
  RankParticles particles{owned,
                          owned + static_cast<std::size_t>(atom.nghost),
                          rows(atom.x),
                          rows(atom.v),
                          rows(atom.f),
                          atom.tag,
                          {},
                          lammps.domain->sublo,
                          lammps.domain->subhi};
  if (auto const* const list = lammps.force->pair->list)
    particles.list = {static_cast<std::size_t>(list->inum), list->ilist, list->numneigh, list->firstneigh,
                      NEIGHMASK};
  return particles;
}

FluidCommands fluid_commands(DecomposedFluid const& fluid) {
  return {.before = {"units lj", "atom_style atomic", "newton on", "atom_modify map array", "boundary p p p"},
          .after = {fmt::format("timestep {}", fluid.dt()), fmt::format("neighbor {} bin", fluid.skin()),
                    fmt::format("comm_modify cutoff {}", fluid.reach()),
                    "neigh_modify every 1 delay 0 check yes one 20000 page 400000"}};
}

} // namespace mesobridge::sdpd
