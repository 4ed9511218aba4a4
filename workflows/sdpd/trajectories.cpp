#include "workflows/sdpd/trajectories.hpp"
#include "md/error.hpp"
#include "workflows/paraview_series.hpp"
#include "workflows/store/seal.hpp"
#include <algorithm>
#include <array>

namespace mesobridge::workflows {
namespace {

/// From metres and seconds to the files' nm and ps.
constexpr double nm = 1e9, ps = 1e12, nm_in_angstrom = 10;

ParticleFrame frame_of(std::int64_t done, sdpd::Simulation const& simulation, OutputUnits const& units,
                       double dt, bool si) {
  auto const reduced = simulation.units();
  double const length = reduced.length() * (si ? nm : 1), velocity = reduced.velocity() * (si ? nm / ps : 1);
  auto now = simulation.snapshot();
  for (std::size_t i = 0; i < now.q.size(); ++i)
    now.q[i] *= length, now.p[i] *= velocity;
  ParticleFrame frame{.step = done,
                      .time = static_cast<double>(done) * dt * units.time * (si ? ps : 1),
                      .box = Box{simulation.box().edge * length, simulation.box().periodic},
                      .to_angstrom = si ? nm_in_angstrom : 1,
                      .positions = std::move(now.q),
                      .velocities = std::move(now.p),
                      .scalars = {}};
  for (auto const& field : sdpd::fields) {
    auto& values = now.*field.values;
    if (!field.written || values.empty()) // a quantity that the method does not have
      continue;
    auto const [unit, key] = units.of(field.dimension);
    for (double& value : values)
      value *= unit;
    frame.scalars.emplace_back(std::string(field.name) + key, std::move(values));
  }
  return frame;
}

/// Where a resumed run's schedule is another than before. A file that is written no longer is closed as its
/// run left it; one that is written again, after a part of the run without it, keeps its old frames under
/// another name.
void make_way(std::filesystem::path const& file, std::int64_t every, std::int64_t before) {
  if (every == 0 && before > 0 && file.extension() == ".xyz")
    ExtendedXyzWriter::continue_file(file).close();
  else if (every == 0 && before > 0)
    Store::mend(file);
  if (every == 0 || before > 0 || !std::filesystem::exists(file))
    return;
  auto const numbered = [&](int number) {
    return file.parent_path() /
           fmt::format("{}.{}{}", file.stem().string(), number, file.extension().string());
  };
  int number = 1;
  while (std::filesystem::exists(numbered(number)))
    ++number;
  std::error_code error;
  std::filesystem::rename(file, numbered(number), error);
  if (auto const seal = seal_beside_path(file); !error && std::filesystem::exists(seal))
    std::filesystem::rename(seal, seal_beside_path(numbered(number)), error);
  if (error)
    throw EnvironmentError(fmt::format("cannot rename '{}': {}", file.string(), error.message()));
}

std::array<bool, 3> periodic_axes(Scene const& scene) {
  auto const& box = scene.box;
  return {box.x == "periodic", box.y == "periodic", box.z == "periodic"};
}

H5mdWriter::Units h5md_units(bool si) {
  // The frames are in nm and ps already.
  return {.length = 1, .time = 1, .physical = si};
}

} // namespace

Trajectories::Trajectories(Scene const& scene, std::filesystem::path const& folder,
                           Provenance const& provenance, std::optional<FrameSchedules> const& before)
    : folder_(folder), schedule_(scene.run), si_(scene.units == UnitSystem::SI) {
  auto const h5 = folder / h5md_name, vtk = folder / vtkhdf_name, xyz = folder / "trajectory.xyz";
  auto const past = before.value_or(FrameSchedules{});
  if (before) {
    make_way(h5, schedule_.trajectory_every, past.h5md);
    make_way(vtk, schedule_.vtkhdf_every, past.vtkhdf);
    make_way(xyz, schedule_.xyz_every, past.xyz);
  }
  if (schedule_.trajectory_every > 0)
    h5md_.emplace(past.h5md > 0 ? H5mdWriter::continue_file(h5, h5md_units(si_))
                                : H5mdWriter(h5, h5md_units(si_), provenance, periodic_axes(scene)));
  std::error_code ignored; // there are none
  if (past.vtkhdf == 0)
    std::filesystem::remove_all(folder / paraview_frames, ignored);
  if (schedule_.vtkhdf_every > 0)
    vtkhdf_.emplace(past.vtkhdf > 0 ? VtkHdfWriter::continue_file(vtk) : VtkHdfWriter(vtk, provenance));
  if (schedule_.xyz_every > 0)
    xyz_.emplace(past.xyz > 0 ? ExtendedXyzWriter::continue_file(xyz) : ExtendedXyzWriter(xyz));
}

std::int64_t Trajectories::steps_to_next(std::int64_t done, std::int64_t steps) const {
  for (auto const every : {schedule_.trajectory_every, schedule_.vtkhdf_every, schedule_.xyz_every})
    if (every > 0)
      steps = std::min(steps, every - done % every);
  return steps;
}

void Trajectories::record(std::int64_t done, sdpd::Simulation const& simulation, OutputUnits const& units,
                          double dt) {
  auto due = [&](auto const& writer, std::int64_t every) {
    return writer && done % every == 0 && done > writer->last_step();
  };
  bool const h5 = due(h5md_, schedule_.trajectory_every), vtk = due(vtkhdf_, schedule_.vtkhdf_every),
             xyz = due(xyz_, schedule_.xyz_every);
  if (!h5 && !vtk && !xyz)
    return;
  auto const frame = frame_of(done, simulation, units, dt, si_);
  if (h5)
    h5md_->append({.step = frame.step,
                   .time = frame.time,
                   .box = frame.box,
                   .positions = frame.positions,
                   .velocities = frame.velocities,
                   .scalars = frame.scalars});
  if (vtk)
    vtkhdf_->append(frame);
  if (xyz)
    xyz_->append(frame);
}

template <class F>
void Trajectories::for_each_writer(F const& f) {
  auto const if_there = [&](auto& writer) {
    if (writer)
      f(*writer);
  };
  if_there(h5md_), if_there(vtkhdf_), if_there(xyz_);
}

void Trajectories::mark() {
  for_each_writer([](auto& writer) { writer.mark(); });
}

void Trajectories::close() {
  for_each_writer([](auto& writer) { writer.close(); });
  if (vtkhdf_)
    write_paraview_series(folder_ / vtkhdf_name);
}

} // namespace mesobridge::workflows
