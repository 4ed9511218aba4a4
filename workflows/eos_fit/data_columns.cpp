#include "workflows/eos_fit/data_columns.hpp"
#include "md/error.hpp"
#include "workflows/nearest.hpp"
#include <algorithm>
#include <cctype>
#include <optional>
#include <span>

namespace mesobridge::workflows {
namespace {

using fitting::Quantity;
using Names = std::vector<std::string_view>;

/// One unit and its spellings as `canonical` leaves them; the first is shown, with _ for /.
struct Unit {
  Names spellings;
  double factor;
};

std::vector<Unit> const densities{{{"kg/m3", "kgm-3"}, 1},
                                  {{"g/cm3", "g/cc", "g/ccm", "gcm-3", "gcc", "g/ml", "g/mL"}, 1e3},
                                  {{"Mg/m3", "Mgm-3", "t/m3"}, 1e3},
                                  {{"kg/l", "kg/L", "kg/dm3"}, 1e3}};
std::vector<Unit> const temperatures{{{"K", "Kelvin", "kelvin"}, 1}};
std::vector<Unit> const energies{{{"J/kg", "Jkg-1"}, 1},
                                 {{"kJ/kg", "kJkg-1", "J/g", "Jg-1"}, 1e3},
                                 {{"MJ/kg", "MJkg-1", "kJ/g", "kJg-1", "km2/s2"}, 1e6},
                                 {{"cal/g"}, 4184},
                                 {{"kcal/g"}, 4.184e6}};
std::vector<Unit> const pressures{{{"Pa"}, 1},
                                  {{"kPa", "kpa", "KPa"}, 1e3},
                                  {{"MPa", "MPA"}, 1e6},
                                  {{"GPa", "gpa", "GPA"}, 1e9},
                                  {{"TPa"}, 1e12},
                                  {{"bar"}, 1e5},
                                  {{"kbar", "Kbar", "kBar", "kb"}, 1e8},
                                  {{"Mbar", "MBar", "megabar"}, 1e11},
                                  {{"atm"}, 101325}};
std::vector<Unit> const capacities{{{"J/kg/K", "J/kgK", "Jkg-1K-1"}, 1},
                                   {{"kJ/kg/K", "kJ/kgK", "J/g/K", "J/gK", "kJkg-1K-1"}, 1e3}};
std::vector<Unit> const velocities{{{"m/s", "ms-1"}, 1},
                                   {{"km/s", "kms-1"}, 1e3},
                                   {{"mm/us", "mm/microsec", "mmus-1", "mm/usec"}, 1e3},
                                   {{"cm/us", "cmus-1", "cm/usec"}, 1e4},
                                   {{"mm/s", "mms-1"}, 1e-3},
                                   {{"cm/s", "cms-1"}, 1e-2}};

struct Known {
  Names symbols; ///< the first is ours
  Quantity quantity;
  std::vector<Unit> const* units;
  bool of_start = false;
};

/// D is the usual name of a detonation's v_S.
std::vector<Known> const known{
    {{"rho", "density"}, Quantity::rho, &densities},
    {{"T"}, Quantity::T, &temperatures},
    {{"e"}, Quantity::e, &energies},
    {{"P", "p"}, Quantity::P, &pressures},
    {{"c_v", "cv", "Cv", "C_v"}, Quantity::c_v, &capacities},
    {{"sound_speed"}, Quantity::sound_speed, &velocities},
    {{"v_P", "v_p", "vp", "vP", "up", "u_p", "Up", "U_p", "uP", "UP"}, Quantity::v_P, &velocities},
    {{"v_S", "v_s", "vs", "vS", "us", "u_s", "Us", "U_s", "uS", "US"}, Quantity::v_S, &velocities},
    {{"D"}, Quantity::v_S, &velocities},
    {{"rho0", "rho_0"}, Quantity::rho, &densities, true},
    {{"T0", "T_0"}, Quantity::T, &temperatures, true},
    {{"e0", "e_0"}, Quantity::e, &energies, true},
    {{"P0", "P_0", "p0", "p_0"}, Quantity::P, &pressures, true},
};

constexpr std::string_view marks_of_errors[] = {"se", "err", "error", "sigma"};

std::string shown(std::string_view unit) {
  std::string text(unit);
  std::ranges::replace(text, '/', '_');
  return text;
}

std::string unit_names(Known const& entry) {
  std::vector<std::string> names;
  for (auto const& unit : *entry.units)
    names.push_back(shown(unit.spellings.front()));
  return fmt::format("{}", fmt::join(names, ", "));
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (auto at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

/// A unit without what people write differently: blanks, carets, dots, small raised digits; _ and an opening
/// bracket are /.
std::string canonical(std::string text) {
  for (auto const& [from, to] :
       std::initializer_list<std::pair<std::string_view, std::string_view>>{{"\u00b3", "3"},
                                                                            {"\u00b2", "2"},
                                                                            {"\u00b5", "u"},
                                                                            {"\u03bc", "u"},
                                                                            {"\u00b7", ""},
                                                                            {"\u207b", "-"},
                                                                            {"\u00b9", "1"},
                                                                            {"**", ""},
                                                                            {"_", "/"},
                                                                            {"[", "/"},
                                                                            {"(", "/"}})
    replace_all(text, from, to);
  std::erase_if(text, [](char c) { return std::string_view(" )]^*.").find(c) != std::string_view::npos; });
  while (text.find("//") != text.npos)
    text.erase(text.find("//"), 1);
  while (text.starts_with('/'))
    text.erase(0, 1);
  return text;
}

std::optional<double> factor_of(std::string unit, Known const& entry) {
  if (unit.find('-') != unit.npos) // kg_m-3: a product with negative powers
    std::erase(unit, '/');
  for (auto const& candidate : *entry.units)
    if (std::ranges::find(candidate.spellings, unit) != candidate.spellings.end())
      return candidate.factor;
  return std::nullopt;
}

/// A name in its parts: which quantity, whether its error, and the unit as `canonical` leaves it.
struct Parts {
  Known const* entry;
  bool error;
  std::string unit;
};

bool ends_symbol(std::string_view rest) {
  return rest.empty() || std::string_view("_ [(/").find(rest.front()) != std::string_view::npos;
}

Parts parts_of(Known const& entry, std::string_view rest) {
  std::string unit = canonical(std::string(rest));
  for (auto const known_mark : marks_of_errors) {
    std::string const mark(known_mark);
    if (unit == mark || unit.starts_with(mark + "/"))
      return {&entry, true, unit.substr(std::min(unit.size(), mark.size() + 1))};
    if (unit.ends_with("/" + mark))
      return {&entry, true, unit.substr(0, unit.size() - mark.size() - 1)};
  }
  return {&entry, false, unit};
}

/// By the longest symbol that the name begins with: rho_0_g_cc is rho_0's, not rho's.
std::optional<Parts> parts_of(std::string_view name) {
  Known const* found = nullptr;
  std::size_t longest = 0;
  for (auto const& entry : known)
    for (auto const symbol : entry.symbols)
      if (symbol.size() > longest && name.starts_with(symbol) && ends_symbol(name.substr(symbol.size())))
        found = &entry, longest = symbol.size();
  return found ? std::optional(parts_of(*found, name.substr(longest))) : std::nullopt;
}

bool same_but_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return std::tolower(x) == std::tolower(y); });
}

[[noreturn]] void refuse_unit(std::string const& name, Parts const& parts) {
  auto const symbol = parts.entry->symbols.front();
  if (parts.unit.empty())
    throw InputError(fmt::format("column '{}' does not say its unit; units of {}: {}", name, symbol,
                                 unit_names(*parts.entry)));
  // m and M differ by 1e9: letters are not proposed where they decide.
  std::string proposal;
  for (auto const& unit : *parts.entry->units)
    if (same_but_case(parts.unit, unit.spellings.front()) && std::tolower(parts.unit.front()) != 'm')
      proposal = fmt::format("; did you mean '{}_{}'?", symbol, shown(unit.spellings.front()));
  throw InputError(fmt::format("unknown column '{}'{}; the unit '{}' is none of {}, which are: {}", name,
                               proposal, parts.unit, symbol, unit_names(*parts.entry)));
}

/// Proposes another quantity only with the unit that stands there.
[[noreturn]] void refuse_symbol(std::string const& name) {
  std::vector<std::string> candidates{"P_e_correlation", "kind"};
  for (auto const& entry : known)
    for (auto const& unit : *entry.units)
      if (auto const ending = "_" + shown(unit.spellings.front()); name.ends_with(ending))
        candidates.push_back(std::string(entry.symbols.front()) + ending);
  throw InputError(fmt::format("unknown column '{}'{}; known: {}", name, did_you_mean(name, candidates),
                               known_data_columns()));
}

} // namespace

DataColumn parse_data_column(std::string const& name) {
  using Role = DataColumn::Role;
  if (name == "P_e_correlation")
    return {.role = Role::P_e_correlation};
  auto const parts = parts_of(name);
  if (!parts)
    refuse_symbol(name);
  auto const factor = factor_of(parts->unit, *parts->entry);
  if (!factor)
    refuse_unit(name, *parts);
  auto const role = parts->entry->of_start ? (parts->error ? Role::start_error : Role::start)
                    : parts->error         ? Role::standard_error
                                           : Role::value;
  return {role, parts->entry->quantity, *factor};
}

bool is_remark(std::string const& name) {
  for (auto const* const remark : {"phase", "source", "comment", "remark", "reference", "note", "shot"})
    if (same_but_case(name, remark))
      return true;
  return false;
}

bool is_derived(std::string const& name) {
  return name == "s_J_kg_K" || name == "gruneisen" || name == "sound_speed_squared_m2_s2";
}

std::vector<std::pair<std::string, std::string>> data_columns_and_units() {
  std::vector<std::pair<std::string, std::string>> all;
  for (auto const& entry : known)
    all.emplace_back(entry.symbols.front(), unit_names(entry));
  return all;
}

std::string known_data_columns() {
  std::string text;
  for (auto const& [symbol, units] : data_columns_and_units())
    text += fmt::format("{} [{}], ", symbol, units);
  return text + "each as name_unit; standard errors as name_se_unit; P_e_correlation; kind";
}

} // namespace mesobridge::workflows
