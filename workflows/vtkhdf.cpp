#include "workflows/vtkhdf.hpp"
#include "md/error.hpp"
#include "workflows/sdpd/last_step.hpp"
#include <array>
#include <numeric>

namespace mesobridge::workflows {
namespace {

std::string const root = "VTKHDF/";
std::string const step_numbers = "mesobridge/step";

void append_one(Store& store, std::string const& path, std::int64_t value) {
  store.append(path, std::span<std::int64_t const>(&value, 1));
}

} // namespace

VtkHdfWriter::VtkHdfWriter(std::filesystem::path const& file, Provenance const& provenance)
    : store_(file, Store::Mode::create, Store::Safety::marked) {
  std::array<std::int64_t, 2> const format{2, 0};
  store_.set_attribute("VTKHDF", "Version", std::span<std::int64_t const>(format));
  store_.set_ascii_attribute("VTKHDF", "Type", "UnstructuredGrid");
  store_.set_attribute(root + "Steps", "NSteps", std::int64_t{0});
  write_provenance(store_, provenance);
  store_.mark();
}

VtkHdfWriter VtkHdfWriter::continue_file(std::filesystem::path const& file) {
  Store store(file, Store::Mode::append, Store::Safety::marked);
  if (!store.has_attribute("VTKHDF", "Version"))
    throw InputError(fmt::format("'{}' is no VTKHDF file", file.string()));
  return VtkHdfWriter(std::move(store));
}

std::int64_t VtkHdfWriter::last_step() const {
  return workflows::last_step(store_, step_numbers);
}

/// Every particle is a cell of its own, of the type VTK_VERTEX; written once, used by all steps.
void VtkHdfWriter::write_vertices(std::size_t count) {
  std::vector<std::int64_t> places(count + 1);
  std::iota(places.begin(), places.end(), 0);
  store_.write(root + "Offsets", std::span<std::int64_t const>(places));
  store_.write(root + "Connectivity", std::span<std::int64_t const>(places).first(count));
  constexpr std::uint8_t vtk_vertex = 1;
  std::vector<std::uint8_t> const types(count, vtk_vertex);
  store_.write(root + "Types", std::span<std::uint8_t const>(types));
}

void VtkHdfWriter::append_points(std::string const& name, std::vector<Vec3> const& values) {
  std::vector<double> flat;
  flat.reserve(3 * values.size());
  for (auto const& v : values)
    flat.insert(flat.end(), {v.x, v.y, v.z});
  store_.append(root + name, flat, {3});
}

/// Where the arrays of this step begin.
void VtkHdfWriter::append_step(ParticleFrame const& frame, std::int64_t done) {
  auto const count = static_cast<std::int64_t>(frame.positions.size());
  for (auto const* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    append_one(store_, root + name, count);
  store_.append(root + "Steps/Values", std::span<double const>(&frame.time, 1));
  append_one(store_, root + "Steps/PartOffsets", done);
  append_one(store_, root + "Steps/NumberOfParts", 1);
  append_one(store_, root + "Steps/PointOffsets", done * count);
  append_one(store_, root + "Steps/CellOffsets", 0);
  append_one(store_, root + "Steps/ConnectivityIdOffsets", 0);
  append_one(store_, root + "Steps/PointDataOffsets/velocity", done * count);
  append_one(store_, root + "Steps/PointDataOffsets/id", 0);
  for (auto const& [name, values] : frame.scalars)
    append_one(store_, root + "Steps/PointDataOffsets/" + name, done * count);
}

void VtkHdfWriter::append(ParticleFrame const& frame) {
  frame.check();
  auto const done = store_.read_integer_attribute(root + "Steps", "NSteps", {.least = 0, .most = 1e9});
  if (done == 0) {
    write_vertices(frame.positions.size());
    store_.write(root + "PointData/id",
                 std::span<std::int64_t const>(store_.read_integers(root + "Connectivity")));
  }
  append_points("Points", frame.positions);
  append_points("PointData/velocity", frame.velocities);
  for (auto const& [name, values] : frame.scalars)
    store_.append(root + "PointData/" + name, values);
  append_step(frame, done);
  append_one(store_, step_numbers, frame.step);
  store_.set_attribute(root + "Steps", "NSteps", done + 1);
  store_.flush();
}

} // namespace mesobridge::workflows
