#include "workflows/paraview_series.hpp"
#include "md/error.hpp"
#include "workflows/command.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <array>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

std::string const vtk_group = "VTKHDF/";

/// Where the numbers of one frame lie in the trajectory, as its Steps say.
struct FramePlaces {
  std::int64_t part, points, particles;
};

void write_frame(std::filesystem::path const& file, Store const& trajectory, FramePlaces const& at) {
  auto unfinished = file;
  unfinished += ".new";
  Store frame(unfinished, Store::Mode::create);
  std::array<std::int64_t, 2> const format{1, 0};
  frame.set_attribute("VTKHDF", "Version", std::span<std::int64_t const>(format));
  frame.set_ascii_attribute("VTKHDF", "Type", "UnstructuredGrid");
  auto const show = [&](std::string const& name, std::int64_t first, std::int64_t rows) {
    frame.write_view(vtk_group + name, trajectory, vtk_group + name, static_cast<std::size_t>(first),
                     static_cast<std::size_t>(rows));
  };
  for (auto const* of_the_part : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    show(of_the_part, at.part, 1);
  show("Offsets", 0, at.particles + 1);
  for (auto const* of_the_cells : {"Connectivity", "Types"})
    show(of_the_cells, 0, at.particles);
  show("Points", at.points, at.particles);
  for (auto const& name : trajectory.list(vtk_group + "PointData"))
    show("PointData/" + name, name == "id" ? 0 : at.points, at.particles);
  frame.close();
  std::filesystem::rename(unfinished, file);
}

} // namespace

void write_paraview_series(std::filesystem::path const& trajectory) {
  Store const from(trajectory, Store::Mode::read);
  if (!from.contains(vtk_group + "Steps/Values"))
    return; // no frame was due
  auto const times = from.read_doubles(vtk_group + "Steps/Values");
  auto const parts = from.read_integers(vtk_group + "Steps/PartOffsets"),
             points = from.read_integers(vtk_group + "Steps/PointOffsets"),
             particles = from.read_integers(vtk_group + "NumberOfPoints"),
             steps = from.read_integers("mesobridge/step");
  auto const folder = trajectory.parent_path() / paraview_frames;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
  auto files = Json::array();
  for (std::size_t k = 0; k < times.size(); ++k) {
    auto const name = fmt::format("{:09}.hdf", steps.at(k));
    if (!std::filesystem::exists(folder / name))
      write_frame(folder / name, from,
                  {parts.at(k), points.at(k), particles.at(static_cast<std::size_t>(parts.at(k)))});
    files.push_back({{"name", "trajectory-frames/" + name}, {"time", times[k]}});
  }
  auto series = trajectory;
  write_text_file(series.replace_extension(".hdf.series"),
                  Json{{"file-series-version", "1.0"}, {"files", std::move(files)}}.dump(1) + "\n");
}

} // namespace mesobridge::workflows
