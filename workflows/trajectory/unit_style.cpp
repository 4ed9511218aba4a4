#include "workflows/trajectory/unit_style.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace mesobridge::workflows {

namespace {

constexpr double angstrom = 1e-10, calorie = 4.184, elementary_charge = 1.602176634e-19,
                 avogadro = 6.02214076e23;

std::vector<UnitStyle> const& systems() {
  static std::vector<UnitStyle> const list{
      {"lj", 1, 0, 0, "reduced Lennard-Jones units"},
      // 1 g/mol (A/fs)^2 = 1e-3 kg/mol (1e5 m/s)^2 = 1e7 J/mol; one kcal/mol is 4184 J/mol.
      {"real", 1e7 / (1000 * calorie), angstrom, 1e-15, "g/mol, Angstrom, fs, kcal/mol"},
      // 1 g/mol (A/ps)^2 = 1e-3 kg/mol (100 m/s)^2 = 10 J/mol
      {"metal", 10 / (avogadro * elementary_charge), angstrom, 1e-12, "g/mol, Angstrom, ps, eV"},
      {"si", 1, 1, 1, "kg, m, s, J"},
      {"cgs", 1, 1e-2, 1, "g, cm, s, erg"},
      {"micro", 1, 1e-6, 1e-6, "pg, um, us, pg um2/us2"},
      {"nano", 1, 1e-9, 1e-9, "ag, nm, ns, ag nm2/ns2"},
  };
  return list;
}

struct Symbol {
  char const* text;
  double si;
  bool length; ///< otherwise a time
};

constexpr std::array symbols{
    Symbol{"m", 1, true},        Symbol{"cm", 1e-2, true},           Symbol{"mm", 1e-3, true},
    Symbol{"um", 1e-6, true},    Symbol{"µm", 1e-6, true},           Symbol{"nm", 1e-9, true},
    Symbol{"pm", 1e-12, true},   Symbol{"Angstrom", angstrom, true}, Symbol{"angstrom", angstrom, true},
    Symbol{"Å", angstrom, true}, Symbol{"A", angstrom, true},        Symbol{"s", 1, false},
    Symbol{"ms", 1e-3, false},   Symbol{"us", 1e-6, false},          Symbol{"µs", 1e-6, false},
    Symbol{"ns", 1e-9, false},   Symbol{"ps", 1e-12, false},         Symbol{"fs", 1e-15, false}};

[[noreturn]] void refuse(std::string const& unit) {
  throw InputError(fmt::format("the unit '{}' is not known: a product of lengths (m, cm, mm, um, nm, pm, "
                               "Angstrom) and times (s, ms, us, ns, ps, fs) with whole powers, as \"nm "
                               "ps-1\", is read",
                               unit));
}

} // namespace

UnitStyle unit_style(std::string const& name) {
  auto const found = std::ranges::find(systems(), name, &UnitStyle::name);
  if (found != systems().end())
    return *found;
  std::string known;
  for (auto const& system : systems())
    known += (known.empty() ? "" : ", ") + system.name;
  throw InputError(
      fmt::format("units = \"{}\": must be one of LAMMPS's unit styles {}{}", name, known,
                  name == "electron" ? "; electron mixes two units of time, which are not converted" : ""));
}

double value_in_si(std::string const& unit, int lengths, int times) {
  std::istringstream factors(unit);
  double value = 1;
  int of_length = 0, of_time = 0;
  for (std::string factor; factors >> factor;) {
    auto const digits = factor.find_first_of("+-0123456789");
    auto const name = factor.substr(0, digits);
    int power = 1;
    if (digits != factor.npos) {
      auto const* begin = factor.data() + digits + (factor[digits] == '+' ? 1 : 0);
      auto const [end, error] = std::from_chars(begin, factor.data() + factor.size(), power);
      if (error != std::errc() || end != factor.data() + factor.size())
        refuse(unit);
    }
    auto const found = std::ranges::find(symbols, name, [](Symbol const& s) { return std::string(s.text); });
    if (found == symbols.end())
      refuse(unit);
    value *= std::pow(found->si, power);
    (found->length ? of_length : of_time) += power;
  }
  if (of_length != lengths || of_time != times)
    throw InputError(fmt::format("the unit '{}' is no {}", unit,
                                 times == 0     ? "length"
                                 : lengths == 0 ? "time"
                                                : "velocity"));
  return value;
}

} // namespace mesobridge::workflows
