#include "fitting/internal_energy_file.hpp"
#include "fitting/toml_reader.hpp"
#include "fitting/toml_text.hpp"

namespace mesobridge::fitting {
namespace {

constexpr std::string_view format_name = "mesobridge internal energy 1";

struct Kind {
  std::string_view name, table;
};
Kind kind_of(ConstantHeatCapacity const&) {
  return {"constant", "constant"};
}
Kind kind_of(TabulatedHeatCapacity const&) {
  return {"heat-capacity", "heat_capacity"};
}
Kind kind_of(TabulatedEntropy const&) {
  return {"entropy", "entropy"};
}

std::string body(ConstantHeatCapacity const& model) {
  return fmt::format("C_kB = {}\n", exact(model.heat_capacity(1)));
}
std::string body(TabulatedHeatCapacity const& model) {
  return fmt::format("points = {}\nT = {}\nC_kB = {}\neps_min_over_kB = {}\n", model.temperatures().size(),
                     array(model.temperatures()), array(model.heat_capacities()), exact(model.eps_min()));
}
std::string body(TabulatedEntropy const& model) {
  return fmt::format("points = {}\neps_over_kB = {}\nS_kB = {}\n", model.energies().size(),
                     array(model.energies()), array(model.entropies()));
}

/// Arrays of the length that the key `points` says.
std::size_t points_of(TomlReader& table) {
  double const points = table.number("points");
  require(points >= 1 && points <= 1e6 && points == std::floor(points), "points", points,
          "must be the number of points");
  return static_cast<std::size_t>(points);
}

AnyInternalEnergy read_body(TomlReader& file, toml::table const& whole) {
  auto const kind = file.text("kind");
  auto read = [&](std::string_view name, auto const& make) -> AnyInternalEnergy {
    auto table = file.table(name);
    auto model = make(table);
    table.refuse_unknown();
    return model;
  };
  if (kind == "constant")
    return read("constant", [](TomlReader& table) { return ConstantHeatCapacity(table.number("C_kB")); });
  if (kind == "heat-capacity")
    return read("heat_capacity", [](TomlReader& table) {
      std::size_t const points = points_of(table);
      auto T = table.numbers("T", points), C = table.numbers("C_kB", points);
      return TabulatedHeatCapacity(std::move(T), std::move(C), table.number("eps_min_over_kB"));
    });
  if (kind == "entropy")
    return read("entropy", [](TomlReader& table) {
      std::size_t const points = points_of(table);
      auto eps = table.numbers("eps_over_kB", points), S = table.numbers("S_kB", points);
      return TabulatedEntropy(std::move(eps), std::move(S));
    });
  file.refuse(*whole.get("kind"), "kind", "must be one of \"constant\", \"heat-capacity\", \"entropy\"");
}

InternalEnergyModel read_model(toml::table const& whole, std::string const& file_name) {
  TomlReader file(whole, file_name);
  if (file.text("format") != format_name)
    file.refuse(*whole.get("format"), "format", fmt::format("must be \"{}\"", format_name));
  auto const unit = file.text("temperature_unit");
  if (unit != "K" && unit != "reduced")
    file.refuse(*whole.get("temperature_unit"), "temperature_unit", "must be \"K\" or \"reduced\"");
  InternalEnergyModel model{read_body(file, whole), unit == "reduced", {}, {}};
  read_origin(file, model);
  file.refuse_unknown();
  return model;
}

} // namespace

std::string to_toml(InternalEnergyModel const& model) {
  auto const [name, table] = std::visit([](auto const& of) { return kind_of(of); }, model.internal_energy);
  std::string text = fmt::format("format = \"{}\"\nkind = \"{}\"\ntemperature_unit = \"{}\"\n", format_name,
                                 name, model.reduced ? "reduced" : "K");
  text += data_hash_text(model.data_hash);
  text += fmt::format("\n[{}]\n", table);
  text += std::visit([](auto const& of) { return body(of); }, model.internal_energy);
  return text + provenance_text(model.provenance);
}

InternalEnergyModel parse_internal_energy(std::string_view text, std::string const& file_name) {
  return read_toml(text, file_name, read_model);
}

} // namespace mesobridge::fitting
