#include "fitting/particle_model_file.hpp"
#include "fitting/toml_reader.hpp"
#include "fitting/toml_text.hpp"

namespace mesobridge::fitting {
namespace {

constexpr std::string_view format_name = "mesobridge particle 1",
                           former_format = "mesobridge internal energy 1"; // of internal energies alone

/// A column of a table of pairs and its unit in SI.
struct PairColumn {
  std::string_view name, unit;
  bool required;
};
struct PairTable {
  std::string_view name;
  PairColumns ParticleModel::*columns;
  std::vector<PairColumn> keys;
};
std::vector<PairTable> const& pair_tables() {
  static std::vector<PairTable> const tables{
      {"potential", &ParticleModel::potential, {{"r", "_m", true}, {"u", "_J", true}, {"f", "_N", false}}},
      {"friction",
       &ParticleModel::friction,
       {{"r", "_m", true}, {"gamma_par", "_kg_s", true}, {"gamma_perp", "_kg_s", false}}},
      {"conduction", &ParticleModel::conduction, {{"r", "_m", true}, {"kappa", "_W_K", true}}},
  };
  return tables;
}

/// A key as it is called in files: with its unit in SI.
std::string in_file(std::string_view name, std::string_view unit, bool reduced) {
  return std::string(name) + std::string(reduced ? "" : unit);
}

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

PairColumns read_pairs(TomlReader table, PairTable const& of, bool reduced) {
  PairColumns columns;
  std::size_t const points = points_of(table);
  for (auto const& [name, unit, required] : of.keys)
    for (std::string_view const end : {"", "_se"})
      if (auto const key = in_file(std::string(name), unit, reduced) + std::string(end);
          (required && end.empty()) || table.has(key))
        columns[std::string(name) + std::string(end)] = table.numbers(key, points);
  table.refuse_unknown();
  return columns;
}

/// What is known beside the internal energy.
void read_others(TomlReader& file, ParticleModel& model) {
  auto const positive = [](TomlReader& table, std::string const& key) {
    double const value = table.number(key);
    require(value > 0, key, value, "must be > 0");
    return value;
  };
  if (file.has("particle")) {
    auto table = file.table("particle");
    model.mass = positive(table, in_file("mass", "_kg", model.reduced));
    table.refuse_unknown();
  }
  if (file.has("state")) {
    auto table = file.table("state");
    model.state = {positive(table, in_file("rho", "_kg_m3", model.reduced)), positive(table, "T")};
    table.refuse_unknown();
  }
  for (auto const& of : pair_tables())
    if (file.has(of.name))
      model.*of.columns = read_pairs(file.table(of.name), of, model.reduced);
}

ParticleModel read_model(toml::table const& whole, std::string const& file_name) {
  TomlReader file(whole, file_name);
  auto const format = file.text("format");
  if (format != format_name && format != former_format)
    file.refuse(*whole.get("format"), "format", fmt::format("must be \"{}\"", format_name));
  auto const unit = file.text("temperature_unit");
  if (unit != "K" && unit != "reduced")
    file.refuse(*whole.get("temperature_unit"), "temperature_unit", "must be \"K\" or \"reduced\"");
  ParticleModel model{.internal_energy = read_body(file, whole), .reduced = unit == "reduced"};
  read_others(file, model);
  read_origin(file, model);
  file.refuse_unknown();
  return model;
}

std::string others_text(ParticleModel const& model) {
  auto const key = [&](std::string_view name, std::string_view unit) {
    return in_file(name, unit, model.reduced);
  };
  std::string text;
  if (auto const& state = model.state)
    text +=
        fmt::format("\n[state]\n{} = {}\nT = {}\n", key("rho", "_kg_m3"), exact(state->rho), exact(state->T));
  if (model.mass)
    text += fmt::format("\n[particle]\n{} = {}\n", key("mass", "_kg"), exact(*model.mass));
  for (auto const& of : pair_tables()) {
    auto const& columns = model.*of.columns;
    if (columns.empty())
      continue;
    text += fmt::format("\n[{}]\npoints = {}\n", of.name, columns.at("r").size());
    for (auto const& [name, unit, required] : of.keys)
      for (char const* const end : {"", "_se"})
        if (auto const found = columns.find(std::string(name) + end); found != columns.end())
          text += fmt::format("{}{} = {}\n", key(name, unit), end, array(found->second));
  }
  return text;
}

} // namespace

std::string to_toml(ParticleModel const& model) {
  auto const [name, table] = std::visit([](auto const& of) { return kind_of(of); }, model.internal_energy);
  std::string text = fmt::format("format = \"{}\"\nkind = \"{}\"\ntemperature_unit = \"{}\"\n", format_name,
                                 name, model.reduced ? "reduced" : "K");
  text += data_hash_text(model.data_hash);
  text += fmt::format("\n[{}]\n", table);
  text += std::visit([](auto const& of) { return body(of); }, model.internal_energy);
  return text + others_text(model) + provenance_text(model.provenance);
}

ParticleModel parse_particle_model(std::string_view text, std::string const& file_name) {
  return read_toml(text, file_name, read_model);
}

} // namespace mesobridge::fitting
