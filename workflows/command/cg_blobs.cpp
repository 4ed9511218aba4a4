#include "cg/blobs.hpp"
#include "cg/intermolecular.hpp"
#include "md/error.hpp"
#include "workflows/command/star_commands.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/star/mapping_file.hpp"
#include "workflows/star/trajectory_file.hpp"
#include "workflows/summary.hpp"
#include <CLI/CLI.hpp>
#include <cmath>

namespace mesobridge::workflows {

namespace {

struct Options {
  std::filesystem::path trajectory, mapping;
  double time_step = 0.001;
};

cg::BlobFrame blobs_of(cg::BlobMaker& maker, TrajectoryFrame const& frame) {
  cg::BlobFrame result{.step = frame.step, .time = frame.time, .box = frame.box, .blobs = {}};
  auto const n = std::size_t(maker.model().atoms());
  auto const others = cg::intermolecular(maker.model(), frame.q, frame.box);
  for (std::size_t m = 0; m < frame.q.size() / n; ++m) {
    auto blob = maker.blob(std::span(frame.q).subspan(m * n, n), std::span(frame.v).subspan(m * n, n), {}, {},
                           frame.box);
    blob.Phi = others.Phi[m];
    blob.F = others.F[m];
    result.blobs.push_back(blob);
  }
  for (std::size_t m = 0; m < result.blobs.size(); ++m)
    if (auto const& blob = result.blobs[m]; !std::isfinite(blob.U_pot + blob.Phi + norm(blob.F)))
      throw InputError(fmt::format("molecule {} has atoms on top of others at step {}: its energy has no "
                                   "value. Is the trajectory's start overlapping, or the mapping another "
                                   "molecule's?",
                                   m + 1, frame.step));
  cg::refuse_large_molecules(result);
  result.energy = cg::total_energy(result.blobs, maker.model().mass());
  return result;
}

Result blobs(Options const& options, Context const& context) {
  require(options.time_step > 0, "--dt", options.time_step, "must be > 0");
  auto const mapping = read_mapping(options.mapping);
  cg::BlobMaker maker(mapping.model);
  auto const directory = context.output_directory("out/blobs");
  auto const path = directory / "blobs.h5";
  std::optional<BlobFile> file;
  std::size_t frames = 0, molecules = 0;
  std::vector<double> energies;
  read_trajectory(options.trajectory, std::size_t(mapping.model.atoms()), options.time_step,
                  [&](TrajectoryFrame const& frame) {
                    std::vector<cg::BlobFrame> const one{blobs_of(maker, frame)};
                    if (!file) {
                      molecules = one[0].blobs.size();
                      BlobFileHead const head{.kind = "melt",
                                              .name = mapping.name,
                                              .fingerprint = "trajectory " + options.trajectory.string(),
                                              .molecules = int(molecules),
                                              .atoms = mapping.model.atoms(),
                                              .mass = mapping.model.mass(),
                                              .rho = double(frame.q.size()) / frame.box.volume(),
                                              .T = 0,
                                              .set = {}};
                      file.emplace(path, head,
                                   Provenance{.command = context.command_line(),
                                              .seed = 0,
                                              .scene = "",
                                              .inputs = {options.trajectory, options.mapping}});
                    }
                    if (one[0].blobs.size() != molecules)
                      throw InputError(fmt::format("'{}' has {} molecules at step {}, {} before",
                                                   options.trajectory.string(), one[0].blobs.size(),
                                                   frame.step, molecules));
                    file->append(one);
                    energies.push_back(one[0].energy);
                    ++frames;
                  });
  if (!file)
    throw InputError(fmt::format("'{}' holds no frame", options.trajectory.string()));
  file->close();
  Result result;
  result.json = {{"file", path.string()},
                 {"molecules", molecules},
                 {"frames", frames},
                 {"energy_first", energies.front()},
                 {"energy_last", energies.back()}};
  write_summary(directory / "blobs.json", result.json);
  result.text = fmt::format("{} molecules in {} frames: {}", molecules, frames, path.string());
  return result;
}

} // namespace

Command cg_blobs_command() {
  return {.name = "cg blobs",
          .summary = "Blobs (R, P, U, Phi) of a trajectory's molecules",
          .example = "mesobridge cg blobs melt.lammpstrj --mapping star.toml -o out/blobs",
          .declare = [](CLI::App& app) -> Command::Action {
            auto options = std::make_shared<Options>();
            app.add_option("file", options->trajectory, "LAMMPS text dump with velocities, or H5MD (.h5)")
                ->required()
                ->type_name("FILE");
            app.add_option("--mapping", options->mapping, "Atoms, bonds and pair potential of a molecule")
                ->required()
                ->type_name("FILE.toml");
            app.add_option("--dt", options->time_step, "Time step of a dump (default 0.001)");
            return [options](Context& context) { return blobs(*options, context); };
          }};
}

} // namespace mesobridge::workflows
