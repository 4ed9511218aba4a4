#include "workflows/lj/piston_file.hpp"
#include "md/units.hpp"

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

PistonFile::PistonFile(std::filesystem::path const& file, PistonRunInfo const& info,
                       Provenance const& provenance)
    : store_(file, Store::Mode::create), info_(info) {
  write_provenance(store_, provenance);
  store_.set_attribute("settings", "description", info.description);
  store_.set_attribute("settings", "atoms", info.atoms);
  store_.set_attribute("settings", "v_P_m_s", info.v_P);
  store_.set_attribute("settings", "spacing_m", info.spacing);
  store_.set_attribute("settings", "complete", std::int64_t{0});
  std::vector<double> centres;
  for (int s = 0; s < info.slices; ++s)
    centres.push_back((s + 0.5) * info.length / info.slices);
  store_.write(group + "/position_m", centres);
  store_.flush();
}

void PistonFile::append(md::PistonSlices const& slices) {
  double const in_a_slice = static_cast<double>(info_.atoms) / info_.slices;
  std::vector<std::pair<std::string, std::vector<double>>> const columns{
      {"velocity_m_s", scaled(slices.velocity, info_.unit_velocity)},
      {"rho_kg_m3", scaled(slices.number, info_.rho / in_a_slice)},
      {"P_Pa", scaled(slices.P, info_.unit_pressure)},
      {"T_K", scaled(slices.T, info_.unit_temperature)},
      {"number", slices.number}};
  for (auto const& [name, row] : columns)
    store_.append(group + "/" + name, row, {row.size()});
  double const time = slices.time * info_.unit_time, piston = slices.piston * info_.unit_length;
  store_.append(group + "/piston_m", std::span(&piston, 1));
  store_.append(group + "/time_s", std::span(&time, 1));
  store_.flush();
}

void PistonFile::close(bool complete) {
  store_.set_attribute("settings", "complete", std::int64_t{complete});
  store_.close();
}

PistonData read_piston(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  if (!store.is_group(group) || !store.has_attribute("settings", "v_P_m_s"))
    throw InputError(fmt::format("'{}' holds no run of `md piston-shock`", file.string()));
  PistonData data{.description = store.read_text_attribute("settings", "description"),
                  .atoms = store.read_integer_attribute("settings", "atoms", {.least = 1}),
                  .complete = store.read_integer_attribute("settings", "complete") != 0,
                  .scale = {.position = store.read_doubles(group + "/position_m",
                                                           {.least_rows = 2, .row_shape = Store::Shape{}}),
                            .v_P = store.read_double_attribute("settings", "v_P_m_s", {.above = 0}),
                            .spacing = store.read_double_attribute("settings", "spacing_m", {.above = 0})},
                  .frames = {}};
  if (!store.contains(group + "/time_s"))
    return data; // interrupted before its first sample
  auto const time = store.read_doubles(group + "/time_s", {.row_shape = Store::Shape{}});
  Expected const columns{.rows = time.size()};
  auto const piston = store.read_doubles(group + "/piston_m", columns);
  std::size_t const slices = data.scale.position.size();
  Expected const rows{.rows = time.size(), .row_shape = Store::Shape{slices}};
  auto const velocity = store.read_doubles(group + "/velocity_m_s", rows),
             rho = store.read_doubles(group + "/rho_kg_m3", rows),
             P = store.read_doubles(group + "/P_Pa", rows), T = store.read_doubles(group + "/T_K", rows);
  for (std::size_t k = 0; k < time.size(); ++k)
    data.frames.push_back({time[k], piston[k], row_of(velocity, k, slices), row_of(rho, k, slices),
                           row_of(P, k, slices), row_of(T, k, slices)});
  return data;
}

} // namespace mesobridge::workflows
