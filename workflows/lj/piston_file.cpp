#include "workflows/lj/piston_file.hpp"
#include "md/units.hpp"
#include <cmath>

namespace mesobridge::workflows {
namespace {

std::string const group = "profile";

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values)
    value *= factor;
  return values;
}

std::vector<double> row_of(std::vector<double> const& rows, std::size_t k, std::size_t slices) {
  auto const first = rows.begin() + static_cast<std::ptrdiff_t>(k * slices);
  return {first, first + static_cast<std::ptrdiff_t>(slices)};
}

/// What the quantities are called, with their SI unit in SI.
struct Names {
  explicit Names(UnitSystem units) : si(units == UnitSystem::SI) {}
  std::string operator()(std::string const& quantity, char const* unit) const {
    return si ? quantity + "_" + unit : quantity;
  }
  bool si;
};

/// The molecules' frames beside those of the atoms.
void read_molecules(Store const& store, std::size_t slices, PistonData& data) {
  Expected const rows{.rows = data.frames.size(), .row_shape = Store::Shape{slices}};
  auto const number = store.read_doubles(group + "/molecules_number", rows),
             velocity = store.read_doubles(group + "/molecules_velocity", rows),
             T = store.read_doubles(group + "/molecules_T", rows);
  data.energy = store.read_doubles(group + "/energy", {.rows = data.frames.size()});
  for (std::size_t k = 0; k < data.frames.size(); ++k) {
    auto frame = data.frames[k];
    frame.velocity = row_of(velocity, k, slices), frame.T = row_of(T, k, slices);
    data.molecules.push_back(std::move(frame));
  }
}

} // namespace

PistonRunInfo info_of(md::LjPistonSettings const& of) {
  auto const& unit = argon_units;
  return {.description = of.description(),
          .atoms = of.atoms(),
          .slices = of.slices(),
          .v_P = of.v_P * unit.velocity(),
          .spacing = of.spacing() * unit.sigma,
          .length = of.length() * unit.sigma,
          .rho = of.ahead.rho * unit.density(),
          .unit_time = unit.time(),
          .unit_length = unit.sigma,
          .unit_velocity = unit.velocity(),
          .unit_pressure = unit.pressure(),
          .unit_temperature = unit.temperature()};
}

PistonRunInfo info_of(md::MetalPistonSettings const& of) {
  namespace unit = md::metal_units;
  return {.description = of.description(),
          .atoms = of.atoms(),
          .slices = of.slices(),
          .v_P = of.v_P,
          .spacing = of.spacing(),
          .length = of.length(),
          .rho = of.ahead.rho,
          .unit_time = unit::time,
          .unit_length = unit::length,
          .unit_velocity = unit::length / unit::time,
          .unit_pressure = unit::pressure};
}

PistonRunInfo info_of(md::StarPistonSettings const& of) {
  return {.description = of.description(),
          .atoms = of.atoms(),
          .slices = of.slices(),
          .v_P = of.v_P,
          .spacing = std::cbrt(1 / of.rho), // between beads
          .length = of.length(),
          .rho = of.rho,
          .units = UnitSystem::lj};
}

PistonFile::PistonFile(std::filesystem::path const& file, PistonRunInfo const& info,
                       Provenance const& provenance)
    : store_(file, Store::Mode::create), info_(info) {
  write_provenance(store_, provenance);
  store_.set_attribute("settings", "description", info.description);
  store_.set_attribute("settings", "atoms", info.atoms);
  Names const name(info.units);
  store_.set_attribute("settings", name("v_P", "m_s"), info.v_P);
  store_.set_attribute("settings", name("spacing", "m"), info.spacing);
  store_.set_attribute("settings", "complete", std::int64_t{0});
  std::vector<double> centres;
  for (int s = 0; s < info.slices; ++s)
    centres.push_back((s + 0.5) * info.length / info.slices);
  store_.write(group + "/" + name("position", "m"), centres);
  store_.flush();
}

void PistonFile::append(md::PistonSlices const& slices) {
  double const in_a_slice = static_cast<double>(info_.atoms) / info_.slices;
  Names const name(info_.units);
  std::vector<std::pair<std::string, std::vector<double>>> columns{
      {name("velocity", "m_s"), scaled(slices.velocity, info_.unit_velocity)},
      {name("rho", "kg_m3"), scaled(slices.number, info_.rho / in_a_slice)},
      {name("P", "Pa"), scaled(slices.P, info_.unit_pressure)},
      {name("T", "K"), scaled(slices.T, info_.unit_temperature)},
      {"number", slices.number}};
  if (auto const& of = slices.molecules; !of.number.empty()) {
    columns.insert(
        columns.end(),
        {{"molecules_number", of.number}, {"molecules_velocity", of.velocity}, {"molecules_T", of.T}});
    store_.append(group + "/energy", std::span(&slices.energy, 1));
  }
  for (auto const& [name, row] : columns)
    store_.append(group + "/" + name, row, {row.size()});
  double const time = slices.time * info_.unit_time, piston = slices.piston * info_.unit_length;
  store_.append(group + "/" + name("piston", "m"), std::span(&piston, 1));
  store_.append(group + "/" + name("time", "s"), std::span(&time, 1));
  store_.flush();
}

void PistonFile::close(bool complete) {
  store_.set_attribute("settings", "complete", std::int64_t{complete});
  store_.close();
}

PistonData read_piston(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  bool const si = store.has_attribute("settings", "v_P_m_s");
  if (!store.is_group(group) || !(si || store.has_attribute("settings", "v_P")))
    throw InputError(fmt::format("'{}' holds no run of `md piston-shock`", file.string()));
  PistonData data;
  data.units = si ? UnitSystem::SI : UnitSystem::lj;
  Names const name(data.units);
  auto const in = [&](char const* quantity, char const* unit) { return group + "/" + name(quantity, unit); };
  data.description = store.read_text_attribute("settings", "description");
  data.atoms = store.read_integer_attribute("settings", "atoms", {.least = 1});
  data.complete = store.read_integer_attribute("settings", "complete") != 0;
  data.scale = {.position =
                    store.read_doubles(in("position", "m"), {.least_rows = 2, .row_shape = Store::Shape{}}),
                .v_P = store.read_double_attribute("settings", name("v_P", "m_s"), {.above = 0}),
                .spacing = store.read_double_attribute("settings", name("spacing", "m"), {.above = 0})};
  if (!store.contains(in("time", "s")))
    return data; // interrupted before its first sample
  auto const time = store.read_doubles(in("time", "s"), {.row_shape = Store::Shape{}});
  auto const piston = store.read_doubles(in("piston", "m"), {.rows = time.size()});
  std::size_t const slices = data.scale.position.size();
  Expected const rows{.rows = time.size(), .row_shape = Store::Shape{slices}};
  auto const velocity = store.read_doubles(in("velocity", "m_s"), rows),
             rho = store.read_doubles(in("rho", "kg_m3"), rows), P = store.read_doubles(in("P", "Pa"), rows),
             T = store.read_doubles(in("T", "K"), rows);
  for (std::size_t k = 0; k < time.size(); ++k)
    data.frames.push_back({time[k], piston[k], row_of(velocity, k, slices), row_of(rho, k, slices),
                           row_of(P, k, slices), row_of(T, k, slices)});
  if (store.contains(group + "/molecules_T"))
    read_molecules(store, slices, data);
  return data;
}

} // namespace mesobridge::workflows
