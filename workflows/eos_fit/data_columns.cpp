#include "workflows/eos_fit/data_columns.hpp"
#include "md/error.hpp"
#include "workflows/nearest.hpp"
#include <algorithm>
#include <optional>
#include <span>

namespace mesobridge::workflows {
namespace {

using fitting::Quantity;

struct Unit {
  std::string_view name;
  double factor;
};

constexpr Unit densities[] = {{"kg_m3", 1}, {"g_cm3", 1e3}};
constexpr Unit temperatures[] = {{"K", 1}};
constexpr Unit energies[] = {{"J_kg", 1}, {"kJ_kg", 1e3}, {"MJ_kg", 1e6}};
constexpr Unit pressures[] = {{"Pa", 1}, {"MPa", 1e6}, {"GPa", 1e9}, {"kbar", 1e8}};
constexpr Unit capacities[] = {{"J_kg_K", 1}, {"kJ_kg_K", 1e3}};
constexpr Unit velocities[] = {{"m_s", 1}, {"km_s", 1e3}};

struct Known {
  std::string_view symbol;
  Quantity quantity;
  std::span<Unit const> units;
  bool of_start = false;
};

/// D is the usual name of a detonation's v_S.
constexpr Known known[] = {
    {"rho", Quantity::rho, densities},
    {"T", Quantity::T, temperatures},
    {"e", Quantity::e, energies},
    {"P", Quantity::P, pressures},
    {"c_v", Quantity::c_v, capacities},
    {"sound_speed", Quantity::sound_speed, velocities},
    {"v_P", Quantity::v_P, velocities},
    {"v_S", Quantity::v_S, velocities},
    {"D", Quantity::v_S, velocities},
    {"rho0", Quantity::rho, densities, true},
    {"T0", Quantity::T, temperatures, true},
    {"e0", Quantity::e, energies, true},
    {"P0", Quantity::P, pressures, true},
};

std::string unit_names(Known const& entry) {
  std::vector<std::string_view> names;
  for (auto const& unit : entry.units)
    names.push_back(unit.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The name without one "_se" in it, if there is one at its end or right behind the symbol.
std::optional<std::string> without_se(std::string const& name, std::string_view symbol) {
  if (name.ends_with("_se"))
    return name.substr(0, name.size() - 3);
  auto const marked = std::string(symbol) + "_se_";
  if (name.starts_with(marked))
    return std::string(symbol) + "_" + name.substr(marked.size());
  return std::nullopt;
}

std::optional<double> factor_of(std::string const& name, Known const& entry) {
  for (auto const& unit : entry.units)
    if (name == std::string(entry.symbol) + "_" + std::string(unit.name))
      return unit.factor;
  return std::nullopt;
}

[[noreturn]] void refuse(std::string const& name) {
  std::vector<std::string> names{"P_e_correlation", "kind"};
  for (auto const& entry : known) {
    names.push_back(fmt::format("{}_{}", entry.symbol, entry.units[0].name));
    if (name == entry.symbol || name == std::string(entry.symbol) + "_se")
      throw InputError(fmt::format("column '{}' does not say its unit; units of {}: {}", name, entry.symbol,
                                   unit_names(entry)));
  }
  throw InputError(
      fmt::format("unknown column '{}'{}; known: {}", name, did_you_mean(name, names), known_data_columns()));
}

} // namespace

DataColumn parse_data_column(std::string const& name) {
  if (name == "P_e_correlation")
    return {.role = DataColumn::Role::P_e_correlation};
  for (auto const& entry : known) {
    if (auto const factor = factor_of(name, entry))
      return {entry.of_start ? DataColumn::Role::start : DataColumn::Role::value, entry.quantity, *factor};
    if (auto const bare = without_se(name, entry.symbol); bare && !entry.of_start)
      if (auto const factor = factor_of(*bare, entry))
        return {DataColumn::Role::standard_error, entry.quantity, *factor};
  }
  refuse(name);
}

bool is_remark(std::string const& name) {
  return name == "phase" || name == "source" || name == "comment";
}

std::string known_data_columns() {
  std::string text;
  for (auto const& entry : known)
    text += fmt::format("{} [{}], ", entry.symbol, unit_names(entry));
  return text + "each as name_unit; standard errors as name_se_unit; P_e_correlation; kind";
}

} // namespace mesobridge::workflows
