#include "workflows/star/sample_molecules.hpp"
#include "workflows/star/melt_files.hpp"
#include "workflows/star/melt_summary.hpp"
#include "workflows/star/star_sampling.hpp"
#include <cmath>

namespace mesobridge::workflows {

namespace {

/// What is lost in a sum of many energies; an energy that belongs to no atom is far more.
constexpr double round_off = 1e-9;

BlobFileHead molecules_head(md::MoleculeMelt const& melt, double mass, double boltzmann) {
  auto const& molecules = melt.system().molecules;
  return {.kind = "melt",
          .name = molecules.kind.name,
          .fingerprint = melt.fingerprint(),
          .molecules = molecules.count,
          .atoms = molecules.kind.atoms(),
          .mass = mass,
          .rho = melt.protocol().rho,
          .T = boltzmann * melt.protocol().T,
          .units = melt.system().units};
}

void require_whole_energy(cg::BlobFrame const& frame, double mass, std::filesystem::path const& forces) {
  double size = 0;
  for (auto const& blob : frame.blobs)
    size += blob.U_kin + norm2(blob.P) / (2 * mass) + std::abs(blob.U_pot) + std::abs(blob.Phi);
  double const sum = cg::total_energy(frame.blobs, mass);
  if (!(std::abs(sum - frame.energy) <= round_off * size))
    throw InputError(
        fmt::format("'{}': at step {} the molecules' energies are {} together, LAMMPS's total is {}: "
                    "the force field holds energies that belong to no atom",
                    forces.string(), frame.step, sum, frame.energy));
}

/// What LAMMPS takes for constants in the units of a force field.
md::UnitConstants constants_of(md::MpiWorld const& world, md::MoleculeMelt const& melt) {
  md::LammpsSession lammps(world, md::Ranks::own, {});
  lammps.command("units {}", melt.system().units);
  return lammps.unit_constants();
}

bool run_molecules(md::MpiWorld const& world, MoleculesJob const& job, md::MoleculeMelt const& melt,
                   md::UnitConstants const& constants, Context const& context) {
  cg::BlobMaker maker(cg::model_of(melt.system().molecules.kind, constants.energy_of_mv2));
  double const mass = maker.model().mass();
  std::optional<MeltFiles> files;
  std::optional<Progress> progress;
  if (world.is_root()) {
    files.emplace(job.settings.directory, job.resume, molecules_head(melt, mass, constants.boltzmann),
                  Provenance{.command = context.command_line(),
                             .seed = job.settings.seed,
                             .scene = "",
                             .inputs = {job.settings.data, job.settings.forces}});
    progress.emplace(context.progress(
        fmt::format("{} at {:.4g} atoms per volume", melt.system().molecules.kind.name, melt.protocol().rho),
        1));
  }
  auto const take = [&](md::MoleculeFrame const& frame) {
    auto blobs = cg::gather_blobs(world, frame, maker.blobs(frame));
    if (!files)
      return;
    require_whole_energy(blobs, mass, job.settings.forces);
    files->hold(std::move(blobs));
  };
  md::StarConsumers const consumers{.frames = take,
                                    .checkpoint = [&] { return files ? files->write() : void(); },
                                    .steps = watched(progress)};
  return closed(md::sample_molecules(world, melt, job.resume, consumers), files, progress);
}

} // namespace

void sample_molecules(MoleculesJob const& job, Context const& context) {
  std::optional<md::MoleculeMelt> melt;
  md::UnitConstants constants;
  sample_stars(
      job, context,
      [&](md::MpiWorld const& world, MoleculesJob const& of, Context const& in) {
        melt.emplace(of.settings);
        constants = constants_of(world, *melt);
        md::try_forces(world, *melt);
        return run_molecules(world, of, *melt, constants, in);
      },
      [&](MoleculesJob const& done) {
        return molecules_summary(done, *melt, read_blobs(done.blobs()), constants.boltzmann);
      });
}

} // namespace mesobridge::workflows
