#include "workflows/lj/piston_file.hpp"
#include "md/units.hpp"

namespace mesobridge::workflows {
namespace {

std::string const group = "profile";
constexpr auto const& unit = argon_units;

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

LjPistonFile::LjPistonFile(std::filesystem::path const& file, md::LjPistonSettings const& settings,
                           Provenance const& provenance)
    : store_(file, Store::Mode::create), settings_(settings) {
  write_provenance(store_, provenance);
  store_.set_attribute("settings", "description", settings.description());
  store_.set_attribute("settings", "atoms", settings.atoms());
  store_.set_attribute("settings", "v_P_m_s", settings.v_P * unit.velocity());
  store_.set_attribute("settings", "spacing_m", settings.spacing() * unit.sigma);
  store_.set_attribute("settings", "complete", std::int64_t{0});
  std::vector<double> centres;
  for (int s = 0; s < settings.slices(); ++s)
    centres.push_back((s + 0.5) * settings.length() / settings.slices() * unit.sigma);
  store_.write(group + "/position_m", centres);
  store_.flush();
}

void LjPistonFile::append(md::PistonSlices const& slices) {
  double const in_a_slice = static_cast<double>(settings_.atoms()) / settings_.slices();
  std::vector<std::pair<std::string, std::vector<double>>> const columns{
      {"velocity_m_s", scaled(slices.velocity, unit.velocity())},
      {"rho_kg_m3", scaled(slices.number, settings_.ahead.rho * unit.density() / in_a_slice)},
      {"P_Pa", scaled(slices.P, unit.pressure())},
      {"T_K", scaled(slices.T, unit.temperature())},
      {"number", slices.number}};
  for (auto const& [name, row] : columns)
    store_.append(group + "/" + name, row, {row.size()});
  double const time = slices.time * unit.time(), piston = slices.piston * unit.sigma;
  store_.append(group + "/piston_m", std::span(&piston, 1));
  store_.append(group + "/time_s", std::span(&time, 1));
  store_.flush();
}

void LjPistonFile::close(bool complete) {
  store_.set_attribute("settings", "complete", std::int64_t{complete});
  store_.close();
}

LjPistonData read_lj_piston(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  if (!store.is_group(group) || !store.has_attribute("settings", "v_P_m_s"))
    throw InputError(fmt::format("'{}' holds no run of `md piston-shock`", file.string()));
  LjPistonData data{.description = store.read_text_attribute("settings", "description"),
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
