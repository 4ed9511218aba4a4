#include "workflows/h5md.hpp"
#include "md/error.hpp"
#include "workflows/sdpd/last_step.hpp"
#include "workflows/version.hpp"
#include <array>

namespace mesobridge::workflows {

namespace {

constexpr char const* particles = "particles/trajectory"; // where MDAnalysis looks for their number

void append_instant(Store& store, std::string const& group, std::int64_t step, double time) {
  store.append(group + "/step", std::span(&step, 1));
  store.append(group + "/time", std::span(&time, 1));
}

void require_finite(std::vector<double> const& values, std::string const& group, std::int64_t step) {
  for (double const number : values)
    if (!std::isfinite(number))
      throw PhysicsError(
          fmt::format("{} holds a {} at step {}: the frame is not written", group, number, step));
}

/// "T_K" as the format names it: T, in K. Names without a unit that is known here stay whole.
std::pair<std::string, std::string> name_and_unit(std::string const& name) {
  constexpr std::pair<std::string_view, char const*> units[] = {
      {"_kg_m3", "kg m-3"}, {"_J_kg", "J kg-1"}, {"_Pa", "Pa"}, {"_K", "K"}, {"_J", "J"}};
  for (auto const& [ending, unit] : units)
    if (name.ends_with(ending))
      return {name.substr(0, name.size() - ending.size()), unit};
  return {name, ""};
}

} // namespace

H5mdWriter::H5mdWriter(std::filesystem::path const& file, Units units, Provenance const& provenance,
                       std::array<bool, 3> periodic)
    : store_(file, Store::Mode::create, Store::Safety::marked), units_(units) {
  std::array<std::int64_t, 2> const format{1, 1};
  store_.set_attribute("h5md", "version", std::span<std::int64_t const>(format));
  store_.set_attribute("h5md/author", "name", std::string("unknown")); // the format demands the attribute
  store_.set_attribute("h5md/creator", "name", std::string("mesobridge"));
  store_.set_attribute("h5md/creator", "version", std::string(version()));
  if (units.physical) {
    std::array<std::int64_t, 2> const module{1, 0};
    store_.set_attribute("h5md/modules/units", "version", std::span<std::int64_t const>(module));
    store_.set_attribute("h5md/modules/units", "system", std::string("SI"));
  }
  std::vector<std::string> boundary;
  for (bool const leads_round : periodic)
    boundary.emplace_back(leads_round ? "periodic" : "none");
  store_.set_attribute(std::string(particles) + "/box", "dimension", std::int64_t{3});
  store_.set_attribute(std::string(particles) + "/box", "boundary", std::span<std::string const>(boundary));
  write_provenance(store_, provenance);
  store_.mark();
}

H5mdWriter H5mdWriter::continue_file(std::filesystem::path const& file, Units units) {
  Store store(file, Store::Mode::append, Store::Safety::marked);
  if (!store.has_attribute("h5md", "version"))
    throw InputError(fmt::format("'{}' is no H5MD file", file.string()));
  if (!store.is_group(particles))
    throw InputError(
        fmt::format("cannot go on with '{}': it has no group '{}'; an earlier version of mesobridge "
                    "wrote it, begin anew",
                    file.string(), particles));
  return H5mdWriter(std::move(store), units);
}

std::int64_t H5mdWriter::last_step() const {
  std::string const steps = std::string(particles) + "/position/step";
  return workflows::last_step(store_, steps);
}

void H5mdWriter::describe(std::string const& group, std::string const& unit) {
  if (units_.physical && !unit.empty())
    store_.set_attribute(group + "/value", "unit", unit);
  if (units_.physical)
    store_.set_attribute(group + "/time", "unit", std::string("ps"));
}

void H5mdWriter::append_vectors(std::string const& group, Frame const& frame, std::span<Vec3 const> values,
                                double factor, std::string const& unit) {
  std::vector<double> flat;
  flat.reserve(3 * values.size());
  for (auto const& v : values)
    flat.insert(flat.end(), {v.x * factor, v.y * factor, v.z * factor});
  require_finite(flat, group, frame.step);
  bool const first = !store_.contains(group + "/value");
  store_.append(group + "/value", flat, {values.size(), 3});
  append_instant(store_, group, frame.step, frame.time * units_.time);
  if (first)
    describe(group, unit);
}

void H5mdWriter::append_scalar(Frame const& frame, std::string const& name,
                               std::vector<double> const& values) {
  auto const [bare, unit] = name_and_unit(name);
  auto const group = std::string(particles) + "/" + bare;
  bool const first = !store_.contains(group + "/value");
  if (first && continued_)
    return; // a file of an earlier version, in which this would begin late
  require_finite(values, group, frame.step);
  store_.append(group + "/value", values, {values.size()});
  append_instant(store_, group, frame.step, frame.time * units_.time);
  if (!first)
    return;
  describe(group, unit);
  store_.link(group, "observables/" + bare); // where MDAnalysis looks for what it does not know
}

void H5mdWriter::append(Frame const& frame) {
  std::string const all = particles;
  append_vectors(all + "/position", frame, frame.positions, units_.length, "nm");
  if (!frame.velocities.empty())
    append_vectors(all + "/velocity", frame, frame.velocities, units_.length / units_.time, "nm ps-1");

  for (auto const& [name, values] : frame.scalars)
    append_scalar(frame, name, values);

  auto const edges = all + "/box/edges";
  bool const first = !store_.contains(edges + "/value");
  // The format allows three lengths for a rectangular box, but MDAnalysis 2.4 reads three vectors only.
  auto const edge = units_.length * frame.box.edge;
  std::array<double, 9> const vectors{edge.x, 0, 0, 0, edge.y, 0, 0, 0, edge.z};
  store_.append(edges + "/value", std::span<double const>(vectors), {3, 3});
  append_instant(store_, edges, frame.step, frame.time * units_.time);
  if (first)
    describe(edges, "nm");
  store_.flush();
}

void H5mdWriter::append_observable(std::string const& name, std::int64_t step, double time, double value,
                                   std::string const& unit) {
  if (!std::isfinite(value))
    throw PhysicsError(fmt::format("observable {} is {} at step {}: it is not written", name, value, step));
  auto const group = "observables/" + name;
  bool const first = !store_.contains(group + "/value");
  store_.append(group + "/value", std::span<double const>(&value, 1));
  append_instant(store_, group, step, time * units_.time);
  if (first)
    describe(group, unit);
}

void H5mdWriter::flush() {
  store_.flush();
}

void H5mdWriter::close() {
  store_.close();
}

} // namespace mesobridge::workflows
