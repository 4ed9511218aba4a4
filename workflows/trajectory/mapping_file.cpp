#include "workflows/trajectory/mapping_file.hpp"
#include "fitting/toml_reader.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {

namespace {

constexpr int most_atoms = 100000;

/// A whole number within bounds.
int whole(double value, std::string const& key, int low, int high) {
  require(value == std::floor(value) && value >= low && value <= high, key, value,
          fmt::format("must be a whole number, {} ... {}", low, high));
  return int(value);
}

std::size_t count_of(fitting::TomlReader& table, std::string const& name) {
  return std::size_t(whole(table.number("count"), name + ".count", 1, most_atoms));
}

bool yes(fitting::TomlReader& table, char const* key, std::string const& name) {
  auto const text = table.text(key);
  require(text == "yes" || text == "no", name + "." + key, text, "must be \"yes\" or \"no\"");
  return text == "yes";
}

cg::BondLaw fene_bond(double K, double R0, double epsilon, double sigma) {
  require(K > 0, "bonds.K", K, "must be > 0");
  require(R0 > 0, "bonds.R0", R0, "must be > 0");
  require(epsilon >= 0, "bonds.epsilon", epsilon, "must be >= 0");
  require(sigma >= 0, "bonds.sigma", sigma, "must be >= 0");
  return cg::BondLaw::fene(K, R0, epsilon, sigma);
}

cg::BondLaw harmonic_bond(double k, double l) {
  require(k > 0, "bonds.k", k, "must be > 0");
  require(l >= 0, "bonds.l", l, "must be >= 0");
  return cg::BondLaw::harmonic(k, l);
}

/// The laws of the bonds, in order.
std::vector<cg::BondLaw> fene_bonds(fitting::TomlReader& table, std::size_t count) {
  auto const K = table.numbers("K", count), R0 = table.numbers("R0", count),
             epsilon = table.numbers("epsilon", count), sigma = table.numbers("sigma", count);
  std::vector<cg::BondLaw> laws;
  for (std::size_t i = 0; i < count; ++i)
    laws.push_back(fene_bond(K[i], R0[i], epsilon[i], sigma[i]));
  return laws;
}

std::vector<cg::BondLaw> harmonic_bonds(fitting::TomlReader& table, std::size_t count) {
  bool const lammps = table.has("K");
  if (lammps == table.has("k"))
    throw InputError(
        fmt::format("bonds: {}: k (the energy is k (r - l)^2 / 2) or K (LAMMPS's: K (r - l)^2) must "
                    "be given",
                    lammps ? "both k and K are there, one of them" : "neither k nor K is there: one"));
  auto const k = table.numbers(lammps ? "K" : "k", count), l = table.numbers("l", count);
  std::vector<cg::BondLaw> laws;
  for (std::size_t i = 0; i < count; ++i)
    laws.push_back(harmonic_bond(lammps ? 2 * k[i] : k[i], l[i]));
  return laws;
}

void read_bonds(fitting::TomlReader table, cg::MoleculeModel& model) {
  std::size_t const count = count_of(table, "bonds");
  auto const style = table.has("style") ? table.text("style") : "harmonic";
  require(style == "harmonic" || style == "fene", "bonds.style", style, "must be \"harmonic\" or \"fene\"");
  auto const a = table.numbers("a", count), b = table.numbers("b", count);
  auto const laws = style == "fene" ? fene_bonds(table, count) : harmonic_bonds(table, count);
  for (std::size_t i = 0; i < count; ++i) {
    cg::Bond const bond{whole(a[i], "bonds.a", 1, model.atoms()) - 1,
                        whole(b[i], "bonds.b", 1, model.atoms()) - 1, laws[i]};
    require(bond.a != bond.b, "bonds.b", b[i], "must be another atom than bonds.a");
    model.bonds.push_back(bond);
  }
  table.refuse_unknown();
}

void read_pairs(fitting::TomlReader table, cg::MoleculeModel& model) {
  std::size_t const count = count_of(table, "pairs");
  auto const type_a = table.numbers("type_a", count), type_b = table.numbers("type_b", count),
             epsilon = table.numbers("epsilon", count), sigma = table.numbers("sigma", count),
             cutoff = table.numbers("cutoff", count);
  bool const shifted = yes(table, "shifted", "pairs");
  for (std::size_t i = 0; i < count; ++i) {
    int const a = whole(type_a[i], "pairs.type_a", 1, model.type_count) - 1,
              b = whole(type_b[i], "pairs.type_b", 1, model.type_count) - 1;
    require(sigma[i] > 0, "pairs.sigma", sigma[i], "must be > 0");
    require(cutoff[i] > 0, "pairs.cutoff", cutoff[i], "must be > 0");
    cg::PairLaw const law(epsilon[i], sigma[i], cutoff[i], shifted);
    model.pairs[std::size_t(a * model.type_count + b)] = law;
    model.pairs[std::size_t(b * model.type_count + a)] = law;
  }
  if (!yes(table, "bonded", "pairs"))
    for (auto const& bond : model.bonds)
      model.excluded.emplace_back(std::min(bond.a, bond.b), std::max(bond.a, bond.b));
  table.refuse_unknown();
}

/// The mapping whose forces stand in LAMMPS's own files.
Mapping read_lammps(fitting::TomlReader& reader, std::filesystem::path const& folder) {
  for (char const* key : {"atoms", "masses", "types", "bonds", "pairs"})
    if (reader.has(key))
      throw InputError(fmt::format("{}: with [lammps] its two files say it", key));
  auto table = reader.table("lammps");
  auto const data = folder / table.text("data"), settings = folder / table.text("settings");
  std::optional<int> kind;
  if (table.has("kind"))
    kind = whole(table.number("kind"), "lammps.kind", 1, most_atoms);
  table.refuse_unknown();
  md::MoleculeStyles styles;
  if (reader.has("units"))
    styles.units = reader.text("units");
  Mapping mapping{.name = reader.text("name"), .model = {}};
  auto const system =
      std::make_shared<md::MoleculeSystem>(md::read_molecule_system(data, settings, styles, kind));
  mapping.units = unit_style(system->units), mapping.units_given = true;
  mapping.model = cg::model_of(system->molecules.kind, mapping.units.energy_of_mv2);
  mapping.masses = system->molecules.kind.masses();
  mapping.system = system;
  reader.refuse_unknown();
  return mapping;
}

Mapping read(fitting::TomlReader& reader, std::filesystem::path const& folder) {
  if (auto const format = reader.text("format"); format != "mesobridge mapping 1")
    throw InputError(fmt::format("format = '{}': must be \"mesobridge mapping 1\"", format));
  if (reader.has("lammps"))
    return read_lammps(reader, folder);
  Mapping mapping{.name = reader.text("name"), .model = {}};
  mapping.units_given = reader.has("units");
  mapping.units = unit_style(mapping.units_given ? reader.text("units") : "lj");
  auto& model = mapping.model;
  auto const atoms = std::size_t(whole(reader.number("atoms"), "atoms", 1, most_atoms));
  mapping.masses = reader.numbers("masses", atoms);
  for (double const mass : mapping.masses) {
    require(mass > 0, "masses", mass, "must be > 0");
    model.masses.push_back(mass * mapping.units.energy_of_mv2);
  }
  model.types.assign(atoms, 0);
  if (reader.has("types")) {
    auto const types = reader.numbers("types", atoms);
    for (std::size_t i = 0; i < atoms; ++i)
      model.types[i] = whole(types[i], "types", 1, 1000) - 1;
    model.type_count = *std::max_element(model.types.begin(), model.types.end()) + 1;
  }
  model.pairs.assign(std::size_t(model.type_count * model.type_count), cg::PairLaw(0, 1, 0, false));
  if (reader.has("bonds"))
    read_bonds(reader.table("bonds"), model);
  if (reader.has("pairs"))
    read_pairs(reader.table("pairs"), model);
  reader.refuse_unknown();
  return mapping;
}

} // namespace

Mapping read_mapping(std::filesystem::path const& file) {
  auto const table = fitting::parse_toml(read_text_file(file), file.string());
  fitting::TomlReader reader(table, file.string());
  try {
    return read(reader, file.parent_path());
  } catch (InputError const& error) {
    std::string const what = error.what();
    throw InputError(what.starts_with(file.string()) ? what : fmt::format("{}: {}", file.string(), what));
  }
}

} // namespace mesobridge::workflows
