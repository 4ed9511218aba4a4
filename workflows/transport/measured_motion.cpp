#include "workflows/transport/measured_motion.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/sdpd/trajectories.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/trajectory/trajectory_file.hpp"
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

MeasuredMotion motion_of_blobs(std::filesystem::path const& file) {
  auto data = read_blobs(file);
  auto const head = data.head;
  require(head.rho > 0, "blobs", head.kind,
          "must be those of a melt or a trajectory: isolated molecules do not diffuse");
  refuse_walls(head, file, "diffusion and viscosity");
  require(head.time_unit != "steps", "times of the blobs", "steps",
          "must be times, or D has no unit: give `cg blobs` the time step, --dt");
  auto const folder = file.parent_path();
  return {.series = series_of(std::move(data)),
          .name = head.name,
          .units = units_text(head),
          .file = file,
          .folder = folder.empty() ? "." : folder};
}

/// The mass of each of its particles in the scene's units.
double particle_mass(sdpd::SimulationSettings const& settings) {
  for (auto const& species : settings.reduced_species())
    require(species.mass == 1, "mass of a species, in that of the fluid's particles", species.mass,
            "must be 1: the motion of particles of several masses is not measured");
  return settings.units().mass();
}

void add_frame(cg::BlobSeries& series, TrajectoryFrame const& frame, std::filesystem::path const& file) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!frame.periodic[axis])
      throw InputError(fmt::format("'{}': the box is not periodic along {}: diffusion and viscosity are "
                                   "those of a periodic box",
                                   file.string(), "xyz"[axis]));
  if (!frame.time)
    throw InputError(fmt::format("'{}' says no time of step {}", file.string(), frame.step));
  series.times.push_back(*frame.time), series.boxes.push_back(frame.box);
  series.R.insert(series.R.end(), frame.q.begin(), frame.q.end());
  for (auto const& v : frame.v)
    series.P.push_back(series.mass * v);
}

MeasuredMotion motion_of_run(RunFolder const& folder, Context const& context) {
  auto const now = folder.path() / h5md_name, former = folder.path() / former_h5md_name;
  auto const file = std::filesystem::exists(now) ? now : former;
  if (!folder.holds_run())
    throw InputError(fmt::format("'{}' is no folder of a run: it has no scene.toml that `run` wrote",
                                 folder.path().string()));
  if (!std::filesystem::exists(file))
    throw InputError(fmt::format("'{}' has no trajectory: run the scene with run.trajectory_every, such "
                                 "that a velocity keeps 0.8 of itself from frame to frame",
                                 folder.path().string()));
  Scene const scene = load_scene(folder.scene());
  if (scene.box.body_force)
    throw InputError(fmt::format("'{}' is driven by box.body_force: diffusion and viscosity are measured in "
                                 "a fluid at rest",
                                 folder.path().string()));
  auto const settings = settings_of(scene, 1);
  bool const si = scene.units == UnitSystem::SI;
  MeasuredMotion motion{.series = {.molecules = settings.particle_count(),
                                   .atoms = 1,
                                   .mass = particle_mass(settings),
                                   .times = {},
                                   .boxes = {},
                                   .R = {},
                                   .P = {},
                                   .U = {},
                                   .U_kin = {}},
                        .name = scene.title.empty() ? folder.path().filename().string() : scene.title,
                        .units = si ? "SI" : "reduced Lennard-Jones",
                        .boltzmann = si ? settings.units().boltzmann : 1,
                        .file = file,
                        .folder = folder.path()};
  read_trajectory(file,
                  {.atoms_per_molecule = 1,
                   .units = unit_style(si ? "si" : "lj"),
                   .units_given = true,
                   .warn = [&](std::string const& warning) { context.log->warn("{}", warning); }},
                  [&](TrajectoryFrame const& frame) { add_frame(motion.series, frame, file); });
  auto const in_file = motion.series.R.size() / std::max<std::size_t>(1, motion.series.times.size());
  require(in_file == motion.series.molecules, "particles of the trajectory", in_file,
          fmt::format("must be {}, those of the scene", motion.series.molecules));
  return motion;
}

} // namespace

MeasuredMotion read_motion(std::filesystem::path const& input, Context const& context) {
  return std::filesystem::is_directory(input) ? motion_of_run(RunFolder(input), context)
                                              : motion_of_blobs(input);
}

} // namespace mesobridge::workflows
